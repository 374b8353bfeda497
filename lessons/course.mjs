// Writes COURSE.md from plans.json, lesson.json and the titles of the lessons: node lessons/course.mjs
// The tests of the page compare the file with `coursePage`.
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const file = (name) => new URL(name, import.meta.url);
const read = (name) => readFileSync(file(name), "utf8");

/** An academic hour, and a session of two. */
const minutesOfHour = 45;
const minutesOfSession = 2 * minutesOfHour;

export const readPlans = () => JSON.parse(read("plans.json"));

const minutesOf = (ids) => ids.reduce((sum, id) => sum + JSON.parse(read(`${id}/lesson.json`)).minutes, 0);

const words = {
    en: {
        title: "Course plans",
        plan: (hours, sessions) => `${hours} hours, ${sessions} sessions`,
        head: "| session | lessons | minutes | left for exercises |",
        or: " *or* ",
        text: `An hour is an academic hour of ${minutesOfHour} minutes, and a session has two hours. \`./dev derive\` writes this file from
[\`plans.json\`](plans.json) and from the minutes that each lesson states. These are estimates, not measured in class: a minute for 100 words,
half a minute for each step of a run that is shown, and two minutes for each question, rounded to five minutes. The rest of a session is for
exercises; those that remain are homework. Each lesson states its prerequisites, and the plans respect them.
\`vidno page --no-answers\` makes pages for students without the answers; [HOMEWORK.md](HOMEWORK.md) explains how to give each
student a scene of their own.`,
    },
    ru: {
        title: "Планы курса",
        plan: (hours, sessions) => `Часов: ${hours}, занятий: ${sessions}`,
        head: "| занятие | уроки | минут | остаётся на упражнения |",
        or: " *или* ",
        text: `Час здесь — академический, ${minutesOfHour} минут; в занятии два таких часа. \`./dev derive\` пишет этот файл по
[\`plans.json\`](plans.json) и по минутам, указанным в каждом уроке. Это оценки, на занятиях они не проверялись: минута на 100 слов,
полминуты на каждый показываемый шаг прогона, две минуты на вопрос, с округлением до пяти минут. Остаток занятия — для упражнений;
остальные упражнения — домашнее задание. В каждом уроке указано, какие уроки должны быть пройдены до него; планы это учитывают. \`vidno page --no-answers\`
делает страницы для студентов, без ответов; [HOMEWORK.md](HOMEWORK.md) объясняет (по-английски), как дать каждому студенту
свою сцену.`,
    },
};

const titleOf = (id, language) => /^# (.*)$/m.exec(read(`${id}/story.${language}.md`))[1];
const linkTo = (id, language) => `${Number(id.slice(0, 2))}. [${titleOf(id, language)}](${id}/story.${language}.md)`;

const row = (alternatives, i, language) => {
    const { or } = words[language];
    const each = (say) => alternatives.map(say).join(or);
    const lessons = each((ids) => ids.map((id) => linkTo(id, language)).join("<br>"));
    return `| ${i + 1} | ${lessons} | ${each(minutesOf)} | ${each((ids) => minutesOfSession - minutesOf(ids))} |\n`;
};

const planIn = ({ hours, sessions }, language) => `### ${words[language].plan(hours, sessions.length)}

${words[language].head}
| ---: | --- | ---: | ---: |
${sessions.map((alternatives, i) => row(alternatives, i, language)).join("")}`;

export const coursePage = (plans) =>
    `# ${words.en.title} · ${words.ru.title}\n\n${["en", "ru"]
        .map((language) => {
            const { title, text } = words[language];
            return `## ${title}\n\n${text}\n\n${plans.map((plan) => planIn(plan, language)).join("\n")}`;
        })
        .join("\n")}`;

if (process.argv[1] === fileURLToPath(import.meta.url)) {
    writeFileSync(file("COURSE.md"), coursePage(readPlans()));
}
