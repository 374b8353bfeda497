// Writes GLOSSARY.md from glossary.json: node lessons/glossary.mjs
// The tests of the page compare the file with `glossaryPage`.
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const file = (name) => new URL(name, import.meta.url);

export const readGlossary = () => JSON.parse(readFileSync(file("glossary.json"), "utf8"));

const avoided = ({ never }) => never.map((words) => words.replaceAll("*", "")).join(", ");

const row = ({ en, ru }) =>
    `**${en.term}**<br>${ru.term} | ${en.line}<br>${ru.line} | ${avoided(en)}<br>${avoided(ru)}`;

export const glossaryPage = (entries) => `# Glossary · Словарь

The course's terms in English and Russian. The last column lists the words that the course avoids. \`./dev derive\` writes this file from
[\`glossary.json\`](glossary.json), whose \`find\` lists the forms in which a text uses the term; \`*\` stands for any letters.

| term · термин | meaning · значение | never · никогда |
| --- | --- | --- |
${entries.map((entry) => `| ${row(entry)} |\n`).join("")}`;

if (process.argv[1] === fileURLToPath(import.meta.url)) {
    writeFileSync(file("GLOSSARY.md"), glossaryPage(readGlossary()));
}
