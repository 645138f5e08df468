package org.u2sa.service;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.contract.HealthReport;

/**
 * What a service knows of its own condition (thesis 3.5.3). Written by the service's thread, read
 * by any.
 */
final class ServiceHealth {
  private static final int REMEMBERED_CALLBACKS = 256;
  private static final long IDLE = Long.MAX_VALUE;
  private static final double MEDIAN = 0.50;
  private static final double WORST_PERCENT = 0.99;

  private final Clock stopwatch =
      new SystemClock(); // how long code takes is real time in simulations too
  private final long[] callbackMicros = new long[REMEMBERED_CALLBACKS];
  private long callbacks;
  private long exceptions;
  private int exceptionsInRow;
  private long overruns;
  private long refused; // commands
  private long obeyed; // likewise
  private boolean commanded;
  private long expired;
  private String lastError;
  private Exception lastException;
  private final Map<String, String> remarks = new TreeMap<>(); // by part
  private boolean died;
  private List<String> emergencyStops; // null: heeds none
  private volatile long busySinceMicros = IDLE; // of the stopwatch; written by the service's thread

  /**
   * Runs author's code, measures it, and lets no exception out. Returns whether it ended without
   * one.
   */
  boolean run(CallbackCode code) throws InterruptedException {
    long began = stopwatch.micros();
    busySinceMicros = began;
    try {
      code.run();
      succeeded(stopwatch.micros() - began);
      return true;
    } catch (InterruptedException e) {
      throw e;
    } catch (Exception e) { // also undeclared checked ones, as Kotlin's functions throw
      failed(e, stopwatch.micros() - began);
      return false;
    } finally {
      busySinceMicros = IDLE;
    }
  }

  /** Takes note that the service's thread is back in its author's code, or waits again. */
  void busy(boolean isBusy) {
    busySinceMicros = isBusy ? stopwatch.micros() : IDLE;
  }

  /** How long the author's code that runs now has been running [s]; empty if none does. */
  OptionalDouble runningS() {
    long since = busySinceMicros;
    return since == IDLE
        ? OptionalDouble.empty()
        : OptionalDouble.of(Clock.seconds(Math.max(0, stopwatch.micros() - since)));
  }

  /** Code of a service's author. */
  @FunctionalInterface
  interface CallbackCode {
    void run() throws InterruptedException;
  }

  private synchronized void succeeded(long micros) {
    exceptionsInRow = 0;
    took(micros);
  }

  private synchronized void failed(Exception e, long micros) {
    exceptions++;
    exceptionsInRow++;
    lastException = e;
    lastError = e.toString();
    took(micros);
  }

  private void took(long micros) {
    callbackMicros[(int) (callbacks++ % REMEMBERED_CALLBACKS)] = micros;
  }

  synchronized void overrun(long missedPeriods) {
    overruns += missedPeriods;
  }

  /** Says that the service has actuators, so that its commands are counted. */
  synchronized void hasActuators() {
    commanded = true;
  }

  /** Counts a command that an actuator obeys. */
  synchronized void obeyed() {
    obeyed++;
  }

  /** Counts a command that an actuator did not obey. */
  synchronized void refused() {
    refused++;
  }

  /** Counts a message that was older than its deadline when its turn came; returns the count. */
  synchronized long expired() {
    return ++expired;
  }

  /** Takes note of which emergency stops hold; returns whether they are others than before. */
  synchronized boolean emergencyStops(List<String> identities) {
    boolean changed = !identities.equals(emergencyStops);
    emergencyStops = List.copyOf(identities);
    return changed;
  }

  synchronized void error(String what) {
    lastError = what;
  }

  /** Takes note of what is to be said of a part of the service; empty: nothing. */
  synchronized void remark(String part, String what) {
    if (what.isEmpty()) {
      remarks.remove(part);
    } else {
      remarks.put(part, what);
    }
  }

  /** Takes note that the service's thread died of something. */
  synchronized void died(String ofWhat) {
    died = true;
    lastError = ofWhat;
  }

  synchronized boolean hasDied() {
    return died;
  }

  synchronized int exceptionsInRow() {
    return exceptionsInRow;
  }

  /** The exception that code threw last, or null. */
  synchronized Exception lastException() {
    return lastException;
  }

  synchronized long exceptions() {
    return exceptions;
  }

  synchronized Optional<String> lastError() {
    return Optional.ofNullable(lastError);
  }

  /** Fills in what a health report says of the service's code, and returns the report. */
  synchronized HealthReport addTo(HealthReport report) {
    lastError().ifPresent(report::lastError);
    if (commanded) {
      report.commandsObeyed(obeyed).commandsRefused(refused);
    }
    if (emergencyStops != null) {
      report.emergencyStops(emergencyStops);
    }
    if (!remarks.isEmpty()) {
      List<String> said = new ArrayList<>();
      remarks.forEach((part, what) -> said.add(part + ": " + what));
      report.remarks(said);
    }
    long[] took = Arrays.copyOf(callbackMicros, (int) Math.min(callbacks, REMEMBERED_CALLBACKS));
    return report
        .overruns(overruns)
        .exceptions(exceptions)
        .refused(report.refused() + refused)
        .expired(expired)
        .callbackP50(percentile(took, MEDIAN))
        .callbackP99(percentile(took, WORST_PERCENT));
  }

  /** Time [s] that this share of times [µs], which it reorders, did not exceed; 0 if none. */
  private static double percentile(long[] took, double fraction) {
    return took.length == 0
        ? 0.0
        : Clock.seconds(
            Selection.nth(took, (int) Math.min(took.length - 1L, (long) (fraction * took.length))));
  }
}
