package org.u2sa.cli.look;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import org.u2sa.report.page.Trace;

/** A quantity over a sliding time window. Not thread-safe. */
final class Series {
  /** A value with its arrival time [s of the plot]. */
  record Sample(double timeS, double value) {}

  private final String name;
  private final String unit;
  private final Deque<Sample> samples = new ArrayDeque<>();

  Series(String name, String unit) {
    this.name = name;
    this.unit = unit;
  }

  String name() {
    return name;
  }

  String unit() {
    return unit;
  }

  /** Adds a value and drops those older than the window. */
  void add(double timeS, double value, double windowS) {
    samples.addLast(new Sample(timeS, value));
    forgetBefore(timeS - windowS);
  }

  void forgetBefore(double timeS) {
    while (!samples.isEmpty() && samples.peekFirst().timeS() < timeS) {
      samples.removeFirst();
    }
  }

  Trace trace() {
    Trace trace = new Trace(name);
    samples.forEach(sample -> trace.add(sample.timeS(), sample.value()));
    return trace;
  }

  List<Sample> samples() {
    return List.copyOf(samples);
  }
}
