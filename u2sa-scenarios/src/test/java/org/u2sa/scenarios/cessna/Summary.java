package org.u2sa.scenarios.cessna;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

/** The numbers of a run's {@code summary.json}, and the bounds that every flight must keep. */
final class Summary {
  private static final double LARGEST_MISS_M = 100.0;
  private static final double LARGEST_CROSS_TRACK_RMS_M = 50.0;
  private static final double LARGEST_ALTITUDE_ERROR_M = 30.0;
  private static final double LARGEST_BANK_DEG = 35.0;

  private final String json;

  private Summary(String json) {
    this.json = json;
  }

  static Summary in(Path runDirectory) {
    try {
      return new Summary(Files.readString(runDirectory.resolve("summary.json")));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Every number of a name, in the order of the file. */
  List<Double> numbers(String name) {
    return Pattern.compile('"' + name + "\" : (-?[0-9.]+)")
        .matcher(json)
        .results()
        .map((MatchResult found) -> Double.valueOf(found.group(1)))
        .toList();
  }

  double number(String name) {
    return numbers(name).get(0);
  }

  boolean flag(String name) {
    return json.contains('"' + name + "\" : true");
  }

  double worstMissM() {
    return numbers("missM").stream().mapToDouble(Double::doubleValue).max().orElse(Double.NaN);
  }

  /** Fails unless the flight kept every bound of the project's first issue. */
  void requireGood() {
    assertThat(numbers("waypointsCaptured")).as(toString()).isEqualTo(numbers("waypoints"));
    assertThat(worstMissM()).as(toString()).isLessThanOrEqualTo(LARGEST_MISS_M);
    requireAtMost("crossTrackRmsM", LARGEST_CROSS_TRACK_RMS_M);
    requireAtMost("altitudeMaxErrorM", LARGEST_ALTITUDE_ERROR_M);
    requireAtMost("maxBankDeg", LARGEST_BANK_DEG);
    assertThat(flag("tookOff")).as("took off: %s", this).isTrue();
    assertThat(flag("crashed")).as("crashed: %s", this).isFalse();
    assertThat(flag("stalled")).as("stalled: %s", this).isFalse();
  }

  /**
   * A number that is absent, such as the altitude error of a flight without a level leg, is good.
   */
  private void requireAtMost(String name, double limit) {
    assertThat(numbers(name))
        .as(toString())
        .allSatisfy(value -> assertThat(value).as(name).isLessThanOrEqualTo(limit));
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "captured %.0f of %.0f, worst miss %.1f m, cross-track RMS %s m, altitude error at most %s m, bank at most %s deg, airspeed at least %s m/s%s%s",
        number("waypointsCaptured"),
        number("waypoints"),
        worstMissM(),
        numbers("crossTrackRmsM"),
        numbers("altitudeMaxErrorM"),
        numbers("maxBankDeg"),
        numbers("minAirspeedMps"),
        flag("crashed") ? ", CRASHED" : "",
        flag("stalled") ? ", STALLED" : "");
  }
}
