/** How the page is arranged: around a text and its run, or around a run with all that is known of it. */
export const pageViews = ['lesson', 'workbench'] as const;
export type PageView = (typeof pageViews)[number];

export const isPageView = (name: string): name is PageView =>
  (pageViews as readonly string[]).includes(name);
