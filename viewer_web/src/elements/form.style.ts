import { css } from 'lit';

/** Fields with small names over them, and lists of polygons and corners. */
export const formStyle = css`
  :host {
    display: block;
    font-size: 0.8125rem;
  }
  section {
    margin-top: 0.7rem;
  }
  h3 {
    margin-bottom: 0.3rem;
  }
  small {
    font-weight: 400;
    font-size: 0.6875rem;
  }
  .fields {
    display: grid;
    grid-template-columns: repeat(2, minmax(0, 1fr));
    gap: 0.3rem 0.5rem;
  }
  .fields.four {
    grid-template-columns: repeat(4, minmax(0, 1fr));
  }
  .fields :is(.method, .edition) {
    grid-column: 1 / -1;
  }
  .fields label > span {
    display: block;
    color: var(--soft);
    font-size: 0.6875rem;
  }
  .fields :is(select, input) {
    width: 100%;
    min-width: 0;
    padding: 0 0.25rem;
  }
  .line {
    display: flex;
    gap: 0.45rem;
    align-items: center;
    min-height: 1.75rem;
    margin-top: 0.3rem;
  }
  input[type='checkbox'] {
    width: 1.05rem;
    height: 1.05rem;
    accent-color: var(--accent);
  }
  input[type='color'] {
    flex: none;
    width: 1.9rem;
    height: 1.75rem;
    padding: 1px;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--panel);
    cursor: pointer;
  }
  ol {
    list-style: none;
  }
  li {
    padding: 0.2rem 0;
  }
  li + li {
    border-top: 1px solid var(--line);
  }
  .polygon {
    display: flex;
    gap: 0.25rem;
    align-items: center;
  }
  .name {
    flex: 1;
    width: 0;
    min-width: 2rem;
    min-height: 1.75rem;
    padding: 0 0.35rem;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--panel);
    font-family: var(--mono);
    font-weight: 600;
  }
  .corners {
    min-height: 1.75rem;
    padding: 0 0.4rem;
    white-space: nowrap;
  }
  .rule {
    margin: 0.35rem 0;
    color: var(--soft);
    font-size: 0.75rem;
  }
  .small {
    display: inline-grid;
    place-items: center;
    width: 1.75rem;
    min-height: 1.75rem;
    padding: 0;
    line-height: 1;
  }
  .depth {
    display: flex;
    flex-wrap: wrap;
    gap: 0.5rem;
    align-items: center;
    margin: 0.3rem 0 0;
  }
  .depth label {
    display: flex;
    gap: 0.4rem;
    align-items: center;
  }
  .depth input {
    width: 6rem;
    font-family: var(--mono);
  }
  .depth button {
    padding: 0 0.5rem;
  }
  table {
    width: 100%;
    margin: 0.3rem 0 0.2rem;
  }
  th {
    padding: 0 0.25rem;
    color: var(--soft);
    font-size: 0.6875rem;
    font-weight: 600;
  }
  td {
    padding: 0.1rem;
  }
  td input {
    width: 100%;
    min-width: 0;
    padding: 0 0.2rem;
    font-family: var(--mono);
    font-size: 0.75rem;
  }
  td input[readonly] {
    border-style: dashed;
    color: var(--soft);
  }
  tr.chosen th {
    color: var(--accent);
  }
  .row-tools {
    width: 3.75rem;
    white-space: nowrap;
  }
`;
