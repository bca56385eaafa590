// Starts the app in the page.
import { render } from "preact";
import { App } from "./app";
import { keepApp } from "./state/app-version";
import { waitForInstallOffer } from "./state/install";
import { followScreen, listenForTouch } from "./state/signals-to-hand";
import "./styles/base.css";
import "./styles/frame.css";
import "./styles/controls.css";
import "./styles/content.css";
import "./styles/plots.css";
import "./styles/flight.css";
import "./styles/arm3d.css";
import "./styles/feedback.css";
import "./styles/dashboard.css";
import "./styles/teaching.css";
import "./styles/language.css";
import "./styles/forced-colours.css";
import "./styles/phones.css";
import { language } from "./texts";

const place = document.getElementById("app");
if (place) render(<App />, place);
waitForInstallOffer();
listenForTouch();
followScreen();
void keepApp(language);
