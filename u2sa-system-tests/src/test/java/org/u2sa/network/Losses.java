package org.u2sa.network;

import org.u2sa.messages.contract.HealthReport;

/**
 * What services know to have lost.
 *
 * @param dropped refused by a full inbox
 * @param refused that the way to the broker did not take
 * @param missed that did not arrive, by their numbers
 * @param expired older than their deadline on arrival
 */
record Losses(long dropped, long refused, long missed, long expired) {
  static final Losses NONE = new Losses(0, 0, 0, 0);

  static Losses of(HealthReport report) {
    return new Losses(
        report.dropped(), report.refused(), report.missed().orElse(0), report.expired().orElse(0));
  }

  Losses plus(Losses other) {
    return new Losses(
        dropped + other.dropped,
        refused + other.refused,
        missed + other.missed,
        expired + other.expired);
  }

  Losses minus(Losses other) {
    return new Losses(
        dropped - other.dropped,
        refused - other.refused,
        missed - other.missed,
        expired - other.expired);
  }
}
