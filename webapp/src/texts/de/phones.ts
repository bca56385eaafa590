// German words for setting up phones.
import type { phones as en } from "../en/phones";

export const phones: typeof en = {
  title: "Telefone",
  open: "Telefone und Töne",
  add: "Weiteres Telefon verbinden",
  addHow:
    "Scannen Sie dies mit der Kamera des anderen Telefons. Oder öffnen Sie dort die Adresse und geben Sie den Code ein.",
  picture: "QR-Code, der ein weiteres Telefon verbindet",
  address: "Adresse",
  code: "Code",
  fingerprint: "SHA-256-Fingerabdruck des Zertifikats",
  onlyHere:
    "Nur dieser Computer erreicht den Server. Starten Sie ihn mit --listen 0.0.0.0:8080, damit Telefone ihn erreichen.",
  thisPhone: "Dieses Telefon",
  secured:
    "Die Verbindung ist verschlüsselt. Der Bildschirm bleibt beim Anlernen an, und die App lässt sich installieren.",
  install: "TEAM auf den Startbildschirm",
  installIphone:
    "iPhone: Drücken Sie auf „Teilen“, dann auf „Zum Home-Bildschirm“. Geben Sie dort den Code noch einmal ein.",
  installed: "TEAM wurde vom Startbildschirm geöffnet.",
  soundsOn: "Töne und Vibration sind ein",
  soundsOff: "Töne und Vibration sind aus",
  switchOn: "Töne einschalten",
  switchOff: "Töne ausschalten",
  setUp: "Dieses Telefon einrichten",
  setUpWhy:
    "Einmal auf jedem Telefon: Installieren Sie das Zertifikat dieser Zelle. Es gilt nur für diese Zelle.",
  whichPhone: "Welches Telefon ist es?",
  platforms: { iphone: "iPhone", android: "Android", other: "Computer" },
  certificate: "Zertifikat holen",
  steps: {
    iphone: [
      "Öffnen Sie diese Seite in Safari. Drücken Sie auf „Zertifikat holen“, dann auf „Zulassen“.",
      "Öffnen Sie die Einstellungen. Drücken Sie auf „Profil geladen“, dann auf „Installieren“.",
      "Gehen Sie in den Einstellungen zu Allgemein, Info, Zertifikatsvertrauenseinstellungen. Schalten Sie das Zertifikat TEAM ein.",
      "Kommen Sie zu dieser Seite zurück.",
    ],
    android: [
      "Drücken Sie auf „Zertifikat holen“. Es liegt dann in den Downloads.",
      "Öffnen Sie die Einstellungen und suchen Sie nach „CA-Zertifikat“. Drücken Sie auf „Trotzdem installieren“.",
      "Wählen Sie in den Downloads die Datei team-cell.crt.",
      "Kommen Sie in Chrome zu dieser Seite zurück.",
    ],
    other: [
      "Drücken Sie auf „Zertifikat holen“ und öffnen Sie die Datei.",
      "Fügen Sie sie den vertrauenswürdigen Zertifizierungsstellen des Browsers hinzu.",
      "Kommen Sie zu dieser Seite zurück.",
    ],
  },
  trusted: "Das Zertifikat ist installiert",
  notTrusted: "Noch nicht installiert",
  looking: "Das Zertifikat wird gesucht…",
  openSecured: "TEAM öffnen",
  goOn: "Ohne weiter",
  goOnMeans:
    "Ohne Zertifikat geht alles, aber der Bildschirm kann dunkel werden, und die App lässt sich nicht installieren.",
  insecure: "Diese Verbindung ist nicht verschlüsselt",
  insecureMeans:
    "Der Bildschirm kann beim Anlernen dunkel werden, und die App lässt sich nicht installieren.",
  insecureAsk: "Bitten Sie die Person, die TEAM eingerichtet hat, es mit --https zu starten.",
  dismiss: "Verstanden",
  update: "Eine neue Version von TEAM ist bereit",
  updateWhen: "Laden Sie sie, wenn gerade nichts läuft. Sonst kommt sie beim nächsten Start.",
  reload: "Jetzt laden",
  offlineTitle: "Keine Verbindung",
  offlineWhat: "Dieses Telefon erreicht den Server nicht. Was Sie sehen, ist alt.",
  lastKnown: "Letzter bekannter Zustand",
  heardAt: "Gehört am",
  state: "Zustand",
  robot: "Roboter",
  offlineWait:
    "Es geht von selbst weiter, sobald der Server antwortet. Nichts wird nachträglich gesendet.",
  reconnect: "Noch einmal versuchen",
};
