package org.u2sa.benchmarks.chain;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.LongConsumer;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.Execution;
import org.u2sa.service.U2SAService;

/** Follows a measurement through a service: what it publishes goes back to what it is handling. */
final class Traced implements Execution {
  private final Clock clock;
  private final Causes causes;
  private final LongConsumer onNavigation; // takes when the measurement was sent [ns]
  private long handledNanos = Causes.NONE; // of the service's thread

  Traced(Clock clock, Causes causes, LongConsumer onNavigation) {
    this.clock = clock;
    this.causes = causes;
    this.onNavigation = onNavigation;
  }

  /** When the measurement was sent that the message being handled goes back to [ns]. */
  long handledNanos() {
    return handledNanos;
  }

  @Override
  public Arrival receives(Arrival waiting) {
    if (waiting != null) {
      handledNanos = causes.of(waiting.message());
      if (waiting.channel().equals(Channels.NAVIGATION) && handledNanos != Causes.NONE) {
        onNavigation.accept(handledNanos);
      }
    }
    return waiting;
  }

  @Override
  public boolean publishes(Channel<?> channel, U2SAData message, BooleanSupplier publish) {
    if (channel.equals(Channels.STATE)
        || channel.equals(Channels.NAVIGATION)
        || channel.equals(Channels.ACTUATION)) {
      causes.put(message, handledNanos);
    }
    return publish.getAsBoolean();
  }

  @Override
  public Clock clock() {
    return clock;
  }

  @Override
  public int threadId(int own) {
    return own;
  }

  @Override
  public Optional<Inheritance> inheritance() {
    return Optional.empty();
  }

  @Override
  public void onBehalf(Runnable code) {
    code.run();
  }

  @Override
  public boolean apart(BooleanSupplier code) {
    return code.getAsBoolean();
  }

  @Override
  public boolean takesWritten(BooleanSupplier isWritten) {
    return isWritten.getAsBoolean();
  }

  @Override
  public void connects(String instance) {}

  @Override
  public void made(U2SAService service) {}

  @Override
  public void succeeds(Inheritance inheritance, String connection) {}

  @Override
  public void begins() {}

  @Override
  public void steps() {
    handledNanos = Causes.NONE;
  }

  @Override
  public void ends() {}
}
