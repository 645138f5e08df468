package org.u2sa.service;

import org.u2sa.interfaces.time.Clock;

/**
 * A service that acts only when a message comes in: its author writes {@link #callback} and nothing
 * else.
 */
public abstract class EventDrivenService extends LoopingService {
  /** See {@link U2SAService#U2SAService}. */
  protected EventDrivenService(ServiceContext context, ServiceRole role, String serviceName) {
    super(context, role, serviceName);
  }

  @Override
  final void loop() throws InterruptedException {
    while (isRunning()) {
      handleMessages(Clock.NEVER);
    }
  }
}
