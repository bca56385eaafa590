// Italian words for setting up phones.
import type { phones as en } from "../en/phones";

export const phones: typeof en = {
  title: "Telefoni",
  open: "Telefoni e suoni",
  add: "Aggiungi un altro telefono",
  addHow:
    "Inquadri questo con la fotocamera dell’altro telefono, oppure apra lì l’indirizzo e digiti il codice.",
  picture: "Codice QR che collega un altro telefono",
  address: "Indirizzo",
  code: "Codice",
  fingerprint: "Impronta SHA-256 del certificato",
  onlyHere:
    "Solo questo computer raggiunge il server. Lo avvii con --listen 0.0.0.0:8080 per ammettere i telefoni.",
  thisPhone: "Questo telefono",
  secured:
    "La connessione è cifrata. Lo schermo resta acceso mentre insegna, e l’app si può installare.",
  install: "Metti TEAM nella schermata Home",
  installIphone:
    "iPhone: prema Condividi, poi “Aggiungi alla schermata Home”. Lì digiti il codice ancora una volta.",
  installed: "TEAM è stato aperto dalla schermata Home.",
  soundsOn: "Suoni e vibrazione attivi",
  soundsOff: "Suoni e vibrazione disattivati",
  switchOn: "Attiva i suoni",
  switchOff: "Disattiva i suoni",
  setUp: "Prepara questo telefono",
  setUpWhy:
    "Una volta su ogni telefono: installi il certificato di questa cella. Vale solo per questa cella.",
  whichPhone: "Quale telefono è?",
  platforms: { iphone: "iPhone", android: "Android", other: "Computer" },
  certificate: "Scarica il certificato",
  steps: {
    iphone: [
      "Apra questa pagina in Safari. Prema “Scarica il certificato”, poi “Consenti”.",
      "Apra Impostazioni, prema “Profilo scaricato”, poi “Installa”.",
      "In Impostazioni vada a Generali, Info, Attendibilità certificati. Attivi il certificato TEAM.",
      "Torni a questa pagina.",
    ],
    android: [
      "Prema “Scarica il certificato”. Viene salvato in Download.",
      "Apra Impostazioni e cerchi “certificato CA”. Prema “Installa comunque”.",
      "Scelga il file team-cell.crt in Download.",
      "Torni a questa pagina in Chrome.",
    ],
    other: [
      "Prema “Scarica il certificato” e apra il file.",
      "Lo aggiunga alle autorità di certificazione attendibili del browser.",
      "Torni a questa pagina.",
    ],
  },
  trusted: "Il certificato è installato",
  notTrusted: "Non ancora installato",
  looking: "Ricerca del certificato…",
  openSecured: "Apri TEAM",
  goOn: "Continua senza",
  goOnMeans:
    "Senza certificato funziona tutto, ma lo schermo può spegnersi e l’app non si può installare.",
  insecure: "Questa connessione non è cifrata",
  insecureMeans: "Lo schermo può spegnersi mentre insegna, e l’app non si può installare.",
  insecureAsk: "Chieda a chi ha installato TEAM di avviarlo con --https.",
  dismiss: "Ho capito",
  update: "Una nuova versione di TEAM è pronta",
  updateWhen: "La carichi quando non c’è niente in corso. Altrimenti arriva al prossimo avvio.",
  reload: "Carica adesso",
  offlineTitle: "Nessuna connessione",
  offlineWhat: "Questo telefono non raggiunge il server. Ciò che vede è vecchio.",
  lastKnown: "Ultimo stato noto",
  heardAt: "Ricevuto il",
  state: "Stato",
  robot: "Robot",
  offlineWait: "Continua da solo appena il server risponde. Niente viene inviato in seguito.",
  reconnect: "Riprova",
};
