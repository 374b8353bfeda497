// Writes GLOSSARY.md from glossary.json and names.json: node lessons/glossary.mjs
// The tests of the page compare the file with `glossaryPage`.
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const file = (name) => new URL(name, import.meta.url);

const read = (name) => JSON.parse(readFileSync(file(name), "utf8"));

export const readGlossary = () => read("glossary.json");

const avoided = ({ never }) => never.map((words) => words.replaceAll("*", "")).join(", ");

const row = ({ en, ru }) =>
    `**${en.term}**<br>${ru.term} | ${en.line}<br>${ru.line} | ${avoided(en)}<br>${avoided(ru)}`;

const both = (en, ru) => (en === ru ? en : `${en}<br>${ru}`);

const nameRow = ({ text, name, en, ru }) => `${text} | ${name} | ${both(en.term, ru.term)} | ${both(en.line, ru.line)}`;

export const glossaryPage = (entries, names = read("names.json")) => `# Glossary · Словарь

The course's terms in English and Russian. The last column lists the words that the course avoids. \`./dev derive\` writes this file from
[\`glossary.json\`](glossary.json), whose \`find\` lists the forms in which a text uses the term; \`*\` stands for any letters.

| term · термин | meaning · значение | never · никогда |
| --- | --- | --- |
${entries.map((entry) => `| ${row(entry)} |\n`).join("")}
## Names of the texts · Имена в текстах

The names in the four texts of [\`TEXTS.md\`](TEXTS.md), beside those of the course's listings; \`./dev derive\` takes them from
[\`names.json\`](names.json).

| text · текст | its name · имя в тексте | here · здесь | meaning · значение |
| --- | --- | --- | --- |
${names.map((name) => `| ${nameRow(name)} |\n`).join("")}`;

if (process.argv[1] === fileURLToPath(import.meta.url)) {
    writeFileSync(file("GLOSSARY.md"), glossaryPage(readGlossary()));
}
