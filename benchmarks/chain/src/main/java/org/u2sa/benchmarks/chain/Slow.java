package org.u2sa.benchmarks.chain;

import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/** Hears all that the chain says, and takes 0.1 s for each message. */
final class Slow extends EventDrivenService {
  private static final long TAKES_MS = 100;

  Slow(ServiceContext context) {
    super(context, ServiceRole.OBSERVER, "Slow");
    registerSubscriber(Channels.SENSED_STATE);
    registerSubscriber(Channels.STATE);
    registerSubscriber(Channels.NAVIGATION);
    registerSubscriber(Channels.ACTUATION);
  }

  @Override
  public void callback(U2SAData data) {
    try {
      Thread.sleep(TAKES_MS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
