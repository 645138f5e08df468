package org.u2sa.core.communication;

import java.io.IOException;
import org.junit.jupiter.api.AfterEach;
import org.u2sa.testkit.TcpRelay;

/** Tests in which the remote client's wire can be cut. */
abstract class WiredClients extends TwoClients {
  TcpRelay wire;

  @Override
  int remotePort() throws IOException {
    wire = new TcpRelay(broker.port);
    return wire.port();
  }

  @Override
  @AfterEach
  void close() {
    super.close();
    wire.close();
  }

  /** Breaks the remote client's connection and waits until it knows. */
  void cutWire() {
    wire.cut();
    remoteInbox.awaitTrouble("lost");
  }

  /** Lets the remote client back and waits until all is as before. */
  void restoreWire() {
    wire.restore();
    remoteInbox.awaitTrouble("restored, subscriptions too");
  }
}
