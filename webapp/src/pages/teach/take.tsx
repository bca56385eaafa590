// One take: while it is being recorded, and afterwards to keep or discard it.
import { LoadNotice } from "../../components/notice";
import { Page } from "../../components/page";
import { demonstrations, loadDemonstration } from "../../state/entities";
import { useLoad } from "../../state/hooks";
import { t } from "../../texts";
import { ClosedTake } from "./closed-take";
import { OpenTake } from "./open-take";

export function TakePage({ task, take: id }: { task: string; take: string }) {
  const load = useLoad(() => loadDemonstration(id), id);
  const take = demonstrations.get(id);
  if (!take) {
    return (
      <Page title={t.teach.takes} back={{ page: "task", task }}>
        <LoadNotice load={load} empty />
      </Page>
    );
  }
  const open = take.state === "preparing" || take.state === "recording";
  return open ? <OpenTake key="open" take={take} /> : <ClosedTake key="closed" take={take} />;
}
