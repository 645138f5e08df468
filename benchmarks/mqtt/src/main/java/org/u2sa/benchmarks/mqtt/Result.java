package org.u2sa.benchmarks.mqtt;

import java.util.Locale;

/**
 * One measurement.
 *
 * @param perS how many were sent a second; 0: as many as arrive, with a limited number on the way
 * @param lost sent, and not arrived three seconds after the last one that was
 * @param cpuMicros processor time of all processes, a message [µs]
 * @param allocatedBytes of the Java processes, a message
 */
record Result(
    String way,
    boolean twoProcesses,
    int bytes,
    int quality,
    int perS,
    int round,
    double p50Micros,
    double p99Micros,
    double p999Micros,
    double arrivedPerS,
    long lost,
    double cpuMicros,
    double allocatedBytes) {

  /** What is measured again each round. */
  String key() {
    return String.format(
        Locale.ROOT,
        "%-18s %-3s %6d B  QoS %d  %s",
        way,
        twoProcesses ? "two" : "one",
        bytes,
        quality,
        perS == 0 ? "flat out" : String.format(Locale.ROOT, "%5d Hz", perS));
  }

  String json() {
    return String.format(
        Locale.ROOT,
        "{\"way\": \"%s\", \"processes\": %d, \"bytes\": %d, \"qos\": %d, \"hz\": %d, \"round\": %d,"
            + " \"p50_us\": %.2f, \"p99_us\": %.2f, \"p99.9_us\": %.2f, \"per_s\": %.1f, \"lost\": %d,"
            + " \"cpu_us\": %.2f, \"allocated_bytes\": %.0f}",
        way,
        twoProcesses ? 2 : 1,
        bytes,
        quality,
        perS,
        round,
        p50Micros,
        p99Micros,
        p999Micros,
        arrivedPerS,
        lost,
        cpuMicros,
        allocatedBytes);
  }
}
