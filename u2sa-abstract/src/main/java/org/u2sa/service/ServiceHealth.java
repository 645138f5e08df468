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
import org.u2sa.service.inbox.CallbackStopwatch;
import org.u2sa.service.inbox.CallbackTimes;

/** A service's own health data (thesis 3.5.3). Thread-safe. */
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
  private final Map<String, String> remarks = new TreeMap<>(); // by part of the service
  private boolean died;
  private List<String> emergencyStops; // null if it does not obey emergency stops
  private final AtomicLong busySinceMicros =
      new AtomicLong(IDLE); // real time; lazily set, because it is only for monitoring

  ServiceHealth(CallbackStopwatch stopwatch) {
    this.stopwatch = stopwatch;
  }

  CallbackStopwatch stopwatch() {
    return stopwatch;
  }

  /** Runs and measures the author's code; false if it threw. */
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
    } catch (Exception e) { // including undeclared checked ones, e.g. of Kotlin
      times.add(stopwatch.end() - began);
      failed(e);
      return false;
    } finally {
      busySinceMicros.lazySet(IDLE);
    }
  }

  /** Time for which the author's code has been running [s]; empty if it is not running. */
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

  synchronized void hasActuators() {
    commanded = true;
  }

  synchronized void obeyed() {
    obeyed++;
  }

  synchronized void refused() {
    refused++;
  }

  synchronized long expired() {
    return ++expired;
  }

  /** Records the emergency stops in force; returns whether they changed. */
  synchronized boolean emergencyStops(List<String> identities) {
    boolean changed = !identities.equals(emergencyStops);
    emergencyStops = List.copyOf(identities);
    return changed;
  }

  synchronized void error(String what) {
    lastError = what;
  }

  synchronized void remark(String part, String what) {
    if (what.isEmpty()) {
      remarks.remove(part);
    } else {
      remarks.put(part, what);
    }
  }

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

  synchronized Exception lastException() {
    return lastException;
  }

  synchronized long exceptions() {
    return exceptions;
  }

  synchronized Optional<String> lastError() {
    return Optional.ofNullable(lastError);
  }

  /** Fills in the fields on the service's code. */
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
