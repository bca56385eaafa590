// Every English word the app shows, grouped by screen. No sentence is put together elsewhere.
import { arm3d } from "./arm3d";
import { control, hold } from "./control";
import { dashboard } from "./dashboard";
import { feedback } from "./feedback";
import { flight } from "./flight";
import { language } from "./language";
import { positions } from "./positions";
import { phones } from "./phones";
import { robot } from "./robot";
import { robots } from "./robots";
import { run } from "./run";
import { signals } from "./signals";
import { teach } from "./teach";
import { teaching } from "./teaching";

export const en = {
  arm3d,
  control,
  dashboard,
  feedback,
  flight,
  hold,
  language,
  positions,
  phones,
  robot,
  robots,
  run,
  signals,
  teach,
  teaching,
  app: {
    name: "TEAM",
    sections: "Sections",
    teach: "Teach",
    run: "Run",
    back: "Back",
    loading: "Loading…",
    tryAgain: "Try again",
    cancel: "Cancel",
    pageMissing: "This page does not exist",
    toTeach: "Go to Teach",
  },
  problems: {
    whatWasWrong: "What was wrong",
    whatToDo: "What to do",
    where: "Where",
    refused: (status: number) => `The server refused this (${status}).`,
    tryAgain: "Try again. If it happens again, ask for help.",
    unreachable: "The server does not answer.",
    checkNetwork: "Check that the phone is in the robot's network, then try again.",
    places: {
      take: (value: string) => `take ${value}`,
      row: (value: string) => `row ${value}`,
      joint: (value: string) => `joint ${value}`,
      t_s: (value: string) => `after ${value} s`,
    } as Record<string, (value: string) => string>,
  },
  stop: {
    button: "Stop",
    sending: "Stopping…",
    sent: "Stop was sent",
    failed: "Stop may not have got through. Use the emergency stop of the robot.",
  },
  pairing: {
    title: "Connect this phone",
    explain: "Type the code that the screen of the TEAM computer shows.",
    code: "Code",
    connect: "Connect",
    connecting: "Connecting…",
  },
  plot: {
    joint: (number: number) => `Joint ${number}`,
    short: (number: number) => `J${number}`,
    degrees: "degrees",
    seconds: "seconds",
    live: "The last ten seconds of all six joints",
    summary: (title: string, seconds: string, widest: number, travel: string) =>
      `${title}: ${seconds}. Joint ${widest} moves most, ${travel}.`,
    numbers: "As numbers",
    start: "Start",
    end: "End",
    lowest: "Lowest",
    highest: "Highest",
    missing: "The plot could not be loaded.",
    empty: "Nothing recorded yet",
  },
  units: {
    degrees: (value: string) => `${value}°`,
    below: (value: string) => `under ${value}`,
    millimetres: (value: string) => `${value} mm`,
    seconds: (value: string) => `${value} s`,
    minutes: (minutes: number, seconds: string) => `${minutes}:${seconds} min`,
    percent: (value: string) => `${value} %`,
  },
};
