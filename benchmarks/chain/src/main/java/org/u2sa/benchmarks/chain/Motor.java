package org.u2sa.benchmarks.chain;

import java.util.function.LongConsumer;
import org.u2sa.service.Actuator;
import org.u2sa.service.ServiceContext;

/** An actuator without a device: says to which measurement each movement goes back. */
final class Motor extends Actuator {
  private final Traced trace;
  private final LongConsumer onMove; // takes when the measurement was sent [ns]

  Motor(ServiceContext context, Traced trace, LongConsumer onMove) {
    super(context.with(trace), "Motor");
    this.trace = trace;
    this.onMove = onMove;
  }

  @Override
  protected void actuate(double percentage) {
    if (trace.handledNanos() != Causes.NONE) {
      onMove.accept(trace.handledNanos());
    }
  }

  @Override
  protected void neutral() {}
}
