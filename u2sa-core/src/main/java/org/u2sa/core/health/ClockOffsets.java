package org.u2sa.core.health;

import java.util.ArrayDeque;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.core.communication.limit.RecentlyUsed;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.HealthReport;

/**
 * Estimates the offsets of other services' clocks from this one: timestamp minus arrival time of
 * the least delayed among several health reports.
 */
final class ClockOffsets {
  private static final int REPORTS = 8; // 2 s at the usual interval
  private static final int MAX_SOURCES = 1_000; // more than fit in an inbox

  private static final class Source {
    private final ArrayDeque<Long> offsetsMicros = new ArrayDeque<>();
    private String instance = "";
    private OptionalDouble saidS = OptionalDouble.empty(); // as last logged; empty: none
  }

  private final Map<String, Source> sources = new RecentlyUsed<>(MAX_SOURCES); // by service

  /** Handles a service's report about itself; returns a new remark on its clock, or empty. */
  Optional<String> hear(HealthReport report, long nowMicros, double toleranceS) {
    if (report.timestamp().isEmpty()) {
      return Optional.empty();
    }
    Source source = sources.computeIfAbsent(report.serviceName(), name -> new Source());
    String instance = report.instance().orElse("");
    if (!instance.equals(source.instance)) {
      source.instance = instance;
      source.offsetsMicros.clear(); // another process, possibly another clock
    }
    source.offsetsMicros.add(report.timestamp().getAsLong() - nowMicros);
    if (source.offsetsMicros.size() < REPORTS) {
      return Optional.empty();
    }
    double offsetS =
        Clock.seconds(source.offsetsMicros.stream().mapToLong(each -> each).max().orElseThrow());
    source.offsetsMicros.poll();
    return judge(report.serviceName(), source, offsetS, toleranceS);
  }

  private Optional<String> judge(String service, Source source, double offsetS, double toleranceS) {
    boolean agrees = Math.abs(offsetS) <= toleranceS;
    boolean same =
        agrees
            ? source.saidS.isEmpty()
            : source.saidS.isPresent()
                && Math.abs(offsetS - source.saidS.getAsDouble()) <= toleranceS;
    if (same) {
      return Optional.empty();
    }
    source.saidS = agrees ? OptionalDouble.empty() : OptionalDouble.of(offsetS);
    return Optional.of(
        agrees
            ? "the clock of " + service + " agrees again"
            : String.format(
                Locale.ROOT,
                "the clock of %s is %.1f s %s this one",
                service,
                Math.abs(offsetS),
                offsetS > 0.0 ? "ahead of" : "behind"));
  }
}
