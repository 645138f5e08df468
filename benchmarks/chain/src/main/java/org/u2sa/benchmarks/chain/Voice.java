package org.u2sa.benchmarks.chain;

import org.u2sa.interfaces.communication.Channel;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/** Publishes on one channel, from the benchmark's thread. */
final class Voice extends EventDrivenService {
  static final double NANOS_PER_S = 1e9; // x of the messages is a time in seconds: its range is ±1e9

  private final Channel<StateInformation> channel;

  Voice(ServiceContext context, Channel<StateInformation> channel) {
    super(context, ServiceRole.OBSERVER, "Voice");
    this.channel = channel;
    registerPublisher(channel);
  }

  /**
   * @param sentNanos 0: not timed [ns]
   * @return whether it was taken
   */
  boolean say(long sentNanos) {
    return publish(channel, new StateInformation().sensorName("Voice").x(sentNanos / NANOS_PER_S));
  }
}
