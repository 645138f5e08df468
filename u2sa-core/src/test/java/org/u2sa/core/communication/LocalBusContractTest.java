package org.u2sa.core.communication;

import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.communication.Transport;

class LocalBusContractTest extends TransportContract {
  private final LocalBus bus = new LocalBus("cessna");

  @Override
  Transport transport() {
    return bus;
  }

  @Override
  void close() {
    // nothing is open
  }
}
