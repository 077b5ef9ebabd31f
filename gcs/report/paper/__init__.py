"""The paper's examples, flown and measured, claim by claim (docs/model/examples.md#paper-examples)."""
