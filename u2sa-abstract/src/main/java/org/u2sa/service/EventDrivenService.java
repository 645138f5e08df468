package org.u2sa.service;

import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.U2SAData;

/**
 * A service that acts only when a message comes in: its author writes one handler for each channel
 * that it {@linkplain #subscribe subscribes} to, or {@link #callback}, and nothing else.
 */
public abstract class EventDrivenService extends U2SAService {
  private final ServiceLoop loop = new ServiceLoop(this);

  /** See {@link U2SAService#U2SAService}. */
  protected EventDrivenService(ServiceContext context, ServiceRole role, String serviceName) {
    super(context, role, serviceName);
  }

  /** Called once on the service's thread before its first message. */
  protected void begin() {}

  @Override
  public void callback(U2SAData data) {
    unexpected(data);
  }

  @Override
  public final void run() {
    loop.run(this::begin, () -> handleMessages(Clock.NEVER));
  }

  @Override
  public final void kill() {
    loop.kill();
  }
}
