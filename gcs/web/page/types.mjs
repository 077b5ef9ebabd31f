// Writes messages.d.ts: the types of a session's lines, out of their JSON Schema.
import { readFileSync, writeFileSync } from "node:fs";

const [from, to] = process.argv.slice(2);
const schema = JSON.parse(readFileSync(from, "utf8"));
const named = (ref) => ref.split("/").pop();

function type(rule) {
  if (rule.$ref) return named(rule.$ref);
  if (rule.anyOf) return rule.anyOf.map(type).join(" | ");
  if (rule.const !== undefined || rule.enum) return (rule.enum ?? [rule.const]).map((one) => JSON.stringify(one)).join(" | ");
  if (rule.prefixItems) return `[${rule.prefixItems.map(type).join(", ")}]`;
  if (rule.type === "array") return `(${type(rule.items ?? {})})[]`;
  if (rule.type === "object" && rule.properties) return body(rule);
  if (rule.type === "object") return `Record<string, ${type(rule.additionalProperties ?? {})}>`;
  return { integer: "number", number: "number", string: "string", boolean: "boolean", null: "null" }[rule.type] ?? "unknown";
}

function body(rule) {
  const required = new Set(rule.required ?? []);
  const fields = Object.entries(rule.properties).map(([name, one]) => `  ${name}${required.has(name) ? "" : "?"}: ${type(one)};`);
  return `{\n${fields.join("\n")}\n}`;
}

const parts = Object.entries(schema.$defs).map(([name, rule]) => {
  const about = rule.description ? `/** ${rule.description.split("\n")[0]} */\n` : "";
  return `${about}export interface ${name} ${body(rule)}\n`;
});
const line = schema.anyOf.map((one) => named(one.$ref)).join(" | ");
writeFileSync(to, `// Made of gcs/schemas/messages.schema.json by types.mjs.\n\n${parts.join("\n")}\nexport type Line = ${line};\n`);
