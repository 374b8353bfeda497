import { read } from '../replay/read.js';
import type { News, Order } from '../replay/read.js';
import './models.js';

/** The part of a worker's global scope that a page's scope does not have. */
interface Scope {
  onmessage: ((message: MessageEvent<Order>) => void) | null;
  postMessage(news: News, transfer: readonly Transferable[]): void;
}
const scope = globalThis as unknown as Scope;

/** The buffers to transfer instead of copying: bytes and columns. */
function given(news: News): readonly Transferable[] {
  if (news.is !== 'part') return [];
  const { bytes, starts, names } = news.block;
  return [bytes.buffer, starts.buffer, names.buffer];
}

async function tell({ file, library }: Order): Promise<void> {
  for await (const news of read(file, { library })) scope.postMessage(news, given(news));
}

scope.onmessage = ({ data }) => void tell(data).catch(reportError);
