// A flight record as a picture: the arm as it was measured, and where it was asked to be.
import type { Signal } from "@preact/signals";
import { useComputed } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useMemo } from "preact/hooks";
import type { Flight } from "../api/types";
import { t } from "../texts";
import { ArmView, type PathLine } from "./arm-view";
import { PictureLegend } from "./legend";
import { poseAt, somePoses, type Track } from "./poses";
import { roomOf } from "./room";

const POINTS = 160;

interface Props {
  flight: Flight;
  time: Signal<number>;
  /** Stands right under the picture. */
  children: ComponentChildren;
}

export function FlightPicture({ flight, time, children }: Props) {
  const [measured, commanded] = useMemo<[Track, Track]>(
    () => [
      { timesS: flight.t_s, jointsDeg: flight.measured_deg },
      { timesS: flight.t_s, jointsDeg: flight.commanded_deg },
    ],
    [flight],
  );
  const joints = useComputed(() => poseAt(measured, time.value));
  const ghost = useComputed(() => poseAt(commanded, time.value));
  const paths = useMemo<PathLine[]>(
    () => [
      { look: "path", poses: somePoses(measured, POINTS) },
      { look: "quiet", poses: somePoses(commanded, POINTS) },
    ],
    [measured],
  );
  const room = useMemo(() => roomOf(somePoses(measured, 24)), [measured]);
  return (
    <>
      <ArmView
        joints={joints}
        ghost={ghost}
        paths={paths}
        room={room}
        label={t.arm3d.labels.flight}
      >
        {children}
      </ArmView>
      <PictureLegend shown={["path", "planned", "ghostPlanned"]} />
    </>
  );
}
