"""The paper's examples, flown and measured, claim by claim (model.md 10)."""
