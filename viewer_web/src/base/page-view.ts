/** The layouts of the page: around a text and its run, or around a run with everything known about it. */
export const pageViews = ['lesson', 'workbench'] as const;
export type PageView = (typeof pageViews)[number];

export const isPageView = (name: string): name is PageView =>
  (pageViews as readonly string[]).includes(name);
