package org.u2sa.core.communication;

import java.io.IOException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.messages.schema.U2SAData;

/** Tests of a manager with two clients: one in its own process, one by TCP. */
abstract class TwoClients {
  final TestManager broker = new TestManager();
  final RecordingReceiver localInbox = new RecordingReceiver();
  final RecordingReceiver remoteInbox = new RecordingReceiver();
  Connection local;
  Connection remote;

  @BeforeEach
  void connect() throws IOException {
    int port = remotePort();
    local = broker.local("Local", localInbox);
    remote = broker.keep(TestManager.transport(port).connect("Remote", remoteInbox));
  }

  /** Where the remote client finds the manager. */
  int remotePort() throws IOException {
    return broker.port;
  }

  @AfterEach
  void close() {
    broker.close();
  }

  /** Publishes here until it arrives there. */
  void publishUntilReceived(U2SAData message) {
    BrokerTraffic.publishUntilReceived(local, remoteInbox, message);
  }
}
