// French words for setting up phones.
import type { phones as en } from "../en/phones";

export const phones: typeof en = {
  title: "Téléphones",
  open: "Téléphones et sons",
  add: "Ajouter un téléphone",
  addHow:
    "Scannez ceci avec l’appareil photo de l’autre téléphone, ou ouvrez-y l’adresse et tapez le code.",
  picture: "Code QR qui connecte un autre téléphone",
  address: "Adresse",
  code: "Code",
  fingerprint: "Empreinte SHA-256 du certificat",
  onlyHere:
    "Seul cet ordinateur atteint le serveur. Démarrez-le avec --listen 0.0.0.0:8080 pour admettre les téléphones.",
  thisPhone: "Ce téléphone",
  secured:
    "La connexion est chiffrée. L’écran reste allumé pendant l’apprentissage, et l’application peut être installée.",
  install: "Mettre TEAM sur l’écran d’accueil",
  installIphone:
    "iPhone : appuyez sur Partager, puis sur « Sur l’écran d’accueil ». Tapez-y le code une nouvelle fois.",
  installed: "TEAM a été ouvert depuis l’écran d’accueil.",
  soundsOn: "Sons et vibrations activés",
  soundsOff: "Sons et vibrations désactivés",
  switchOn: "Activer les sons",
  switchOff: "Désactiver les sons",
  setUp: "Préparer ce téléphone",
  setUpWhy:
    "Une fois sur chaque téléphone : installez le certificat de cette cellule. Il ne vaut que pour elle.",
  whichPhone: "Quel téléphone est-ce ?",
  platforms: { iphone: "iPhone", android: "Android", other: "Ordinateur" },
  certificate: "Obtenir le certificat",
  steps: {
    iphone: [
      "Ouvrez cette page dans Safari. Appuyez sur « Obtenir le certificat », puis sur « Autoriser ».",
      "Ouvrez Réglages, appuyez sur « Profil téléchargé », puis sur « Installer ».",
      "Dans Réglages, allez à Général, Informations, Réglages de confiance des certificats. Activez le certificat TEAM.",
      "Revenez à cette page.",
    ],
    android: [
      "Appuyez sur « Obtenir le certificat ». Il est enregistré dans Téléchargements.",
      "Ouvrez Paramètres et cherchez « certificat CA ». Appuyez sur « Installer quand même ».",
      "Choisissez le fichier team-cell.crt dans Téléchargements.",
      "Revenez à cette page dans Chrome.",
    ],
    other: [
      "Appuyez sur « Obtenir le certificat » et ouvrez le fichier.",
      "Ajoutez-le aux autorités de certification approuvées du navigateur.",
      "Revenez à cette page.",
    ],
  },
  trusted: "Le certificat est installé",
  notTrusted: "Pas encore installé",
  looking: "Recherche du certificat…",
  openSecured: "Ouvrir TEAM",
  goOn: "Continuer sans",
  goOnMeans:
    "Sans le certificat, tout fonctionne, mais l’écran peut s’éteindre et l’application ne peut pas être installée.",
  insecure: "Cette connexion n’est pas chiffrée",
  insecureMeans:
    "L’écran peut s’éteindre pendant l’apprentissage, et l’application ne peut pas être installée.",
  insecureAsk: "Demandez à la personne qui a installé TEAM de le démarrer avec --https.",
  dismiss: "Compris",
  update: "Une nouvelle version de TEAM est prête",
  updateWhen: "Chargez-la quand rien n’est en cours. Sinon elle arrive au prochain démarrage.",
  reload: "Charger maintenant",
  offlineTitle: "Pas de connexion",
  offlineWhat: "Ce téléphone n’atteint pas le serveur. Ce qui est affiché est ancien.",
  lastKnown: "Dernier état connu",
  heardAt: "Reçu le",
  state: "État",
  robot: "Robot",
  offlineWait:
    "La suite vient d’elle-même dès que le serveur répond. Rien n’est envoyé après coup.",
  reconnect: "Réessayer",
};
