package org.u2sa.core.safety;

import java.util.Optional;
import java.util.function.Supplier;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.handover.HandOver;

/**
 * Isolates a watch's exceptions from other watches: one that throws reports its own hazard until it
 * handles a message or judges without a fault again.
 */
final class GuardedWatch implements Watch {
  private final Watch watch;
  private Optional<String> fault = Optional.empty();

  GuardedWatch(Watch watch) {
    this.watch = watch;
  }

  @Override
  public Hazard hazard() {
    return watch.hazard();
  }

  @Override
  public boolean hears(Channel<?> channel) {
    return watch.hears(channel);
  }

  @Override
  public void see(U2SAData message, long nowMicros) {
    try {
      watch.see(message, nowMicros);
      fault = Optional.empty();
    } catch (RuntimeException e) {
      fault = Optional.of(failed(e));
    }
  }

  @Override
  public void pilotFlies(long nowMicros) {
    watch.pilotFlies(nowMicros);
  }

  @Override
  public void handOver(HandOver state, long nowMicros) {
    watch.handOver(state, nowMicros);
    fault.ifPresent(words -> state.text(key(), words));
  }

  @Override
  public void takeOver(HandOver state, long nowMicros, boolean upToDate) {
    watch.takeOver(state, nowMicros, upToDate);
    fault = state.text(key());
  }

  private String key() {
    return "fault of " + hazard().words();
  }

  @Override
  public String saved() {
    return watch.saved();
  }

  @Override
  public Optional<String> trouble(long nowMicros) {
    return asked(() -> watch.trouble(nowMicros));
  }

  @Override
  public Optional<String> objection(long nowMicros) {
    return asked(() -> watch.objection(nowMicros));
  }

  private Optional<String> asked(Supplier<Optional<String>> question) {
    if (fault.isPresent()) {
      return fault;
    }
    try {
      return question.get();
    } catch (RuntimeException e) {
      return Optional.of(failed(e));
    }
  }

  private static String failed(RuntimeException e) {
    return "the check failed: " + e;
  }
}
