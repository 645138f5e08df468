"""Talks to a system as any client may: requests of which none changes anything, and whether the answers are as the page says."""
import time
import uuid

import cbor2

NOBODY = "Nobody here"


class Talk:
    """Requests to every service of one system, and refused or harmless ones to one of them."""

    def __init__(self, system, service):
        self.requests = {kind: f"{kind}-{uuid.uuid4()}" for kind in ("transaction", "undo", "order", "arm")}
        self.service = service
        assignment = {"type": ["ConfigurationAssignment"], "variableName": "NO SUCH VARIABLE", "value": "1"}
        self._to_all = (("discovery", "DiscoveryRequest", {}),
                        ("functionality", "FunctionalityRequest", {"serviceName": ""}),
                        ("configuration", "ConfigurationRequest", {"serviceName": ""}))
        self._to_one = (
            ("stop", "StopCommand", {"stopAll": False, "serviceName": NOBODY}),
            ("configuration", "ConfigurationChange", {"serviceName": service, "variableName": "RATE", "value": "much"}),
            ("configuration", "ConfigurationTransaction", {
                "requestId": self.requests["transaction"], "serviceName": service, "assignments": [assignment],
                "author": "check"}),
            ("configuration", "ConfigurationUndo", {
                "requestId": self.requests["undo"], "serviceName": NOBODY, "author": "check"}),
            ("service-orders", "ServiceOrder", {
                "requestId": self.requests["order"], "serviceName": service, "action": "SWAP",
                "className": "no.such.Class", "operator": "check"}),
            ("arming", "ArmCommand", {"requestId": self.requests["arm"], "arm": True, "operator": "check"}))
        self._system = system

    def ask_all(self, client):
        self._send(client, self._to_all)

    def ask_one(self, client):
        self._send(client, self._to_one)

    def _send(self, client, requests):
        for channel, name, fields in requests:
            pairs = {"systemId": self._system, "timestamp": time.time_ns() // 1000, **fields}
            client.publish(f"u2sa/{self._system}/{channel}/{name}", cbor2.dumps(pairs), 1)

    def unanswered(self, answers):
        """What is still to be answered. answers: newest message by class and service."""
        open_requests = []
        for name in sorted(answers["HealthReport"]):
            open_requests += [f"{name}: no {kind}" for kind in (
                "DiscoveryResponse", "FunctionalityResponse", "ConfigurationResponse") if name not in answers[kind]]
        for kind, fields in (
                ("ConfigurationChangeResult", {"variableName": "RATE", "accepted": False, "value": "much"}),
                ("ConfigurationTransactionResult", {"requestId": self.requests["transaction"], "accepted": False}),
                ("ServiceOrderResult", {"requestId": self.requests["order"], "accepted": False})):
            answer = answers[kind].get(self.service, {})
            differing = {name: answer.get(name) for name, value in fields.items() if answer.get(name) != value}
            if differing or not answer.get("reason"):
                open_requests.append(f"{self.service}: no {kind} that refuses with a reason, but {differing}")
        return open_requests
