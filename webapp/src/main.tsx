// Starts the app in the page.
import { render } from "preact";
import { App } from "./app";
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

const place = document.getElementById("app");
if (place) render(<App />, place);
