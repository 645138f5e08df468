package org.u2sa.service;

import org.u2sa.interfaces.time.Clock;

/**
 * A service that acts only on messages: its author writes one handler per {@linkplain #subscribe
 * subscribed} channel, or {@link #callback}.
 */
public abstract class EventDrivenService extends U2SAService {

  /** See {@link U2SAService#U2SAService}. */
  protected EventDrivenService(ServiceContext context, ServiceRole role, String serviceName) {
    super(context, role, serviceName);
  }

  /** Called once on the service's thread before its first message. */
  protected void begin() {}

  @Override
  public final void run() {
    handling.run(threadID, this::begin, () -> handling.until(Clock.NEVER));
  }

  @Override
  final boolean hasReadyMadeLoop() {
    return true;
  }

  @Override
  public final void kill() {
    life.kill();
  }
}
