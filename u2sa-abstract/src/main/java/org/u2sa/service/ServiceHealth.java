package org.u2sa.service;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.HealthReport;

/**
 * What a service knows of its own condition (thesis 3.5.3). Written by the service's thread, read
 * by any.
 */
final class ServiceHealth {
  private static final long IDLE = Long.MAX_VALUE;

  private final CallbackStopwatch stopwatch;
  private final CallbackTimes times = new CallbackTimes();
  private long exceptions;
  private final AtomicInteger exceptionsInRow = new AtomicInteger();
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
  private final AtomicLong busySinceMicros =
      new AtomicLong(IDLE); // real time; set lazily by the service's thread: it is for who watches

  ServiceHealth(CallbackStopwatch stopwatch) {
    this.stopwatch = stopwatch;
  }

  /** The clock that code is measured by. */
  CallbackStopwatch stopwatch() {
    return stopwatch;
  }

  /**
   * Runs author's code, measures it, and lets no exception out. Returns whether it ended without
   * one.
   */
  boolean run(CallbackCode code) throws InterruptedException {
    long began = stopwatch.begin();
    busySinceMicros.lazySet(began);
    try {
      code.run();
      times.add(stopwatch.end() - began);
      if (exceptionsInRow.get() != 0) {
        exceptionsInRow.set(0);
      }
      return true;
    } catch (InterruptedException e) {
      throw e;
    } catch (Exception e) { // also undeclared checked ones, as Kotlin's functions throw
      times.add(stopwatch.end() - began);
      failed(e);
      return false;
    } finally {
      busySinceMicros.lazySet(IDLE);
    }
  }

  /** How long the author's code that runs now has been running [s]; empty if none does. */
  OptionalDouble runningS() {
    long since = busySinceMicros.get();
    return since == IDLE
        ? OptionalDouble.empty()
        : OptionalDouble.of(Clock.seconds(Math.max(0, stopwatch.realMicrosElsewhere() - since)));
  }

  /** Code of a service's author. */
  @FunctionalInterface
  interface CallbackCode {
    void run() throws InterruptedException;
  }

  private synchronized void failed(Exception e) {
    exceptions++;
    exceptionsInRow.incrementAndGet();
    lastException = e;
    lastError = e.toString();
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

  int exceptionsInRow() {
    return exceptionsInRow.get();
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
    CallbackTimes.Percentiles took = times.percentiles();
    return report
        .overruns(overruns)
        .exceptions(exceptions)
        .refused(report.refused() + refused)
        .expired(expired)
        .callbackP50(took.p50S())
        .callbackP99(took.p99S());
  }
}
