package org.u2sa.scenarios.estimate;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/** Errors of published states against truth, in multiples of the standard deviations they claim. */
public final class EstimateErrors {
  /** What is compared. */
  public enum Quantity {
    /** Position, east. */
    X,
    /** Position, north. */
    Y,
    /** True heading. */
    HEADING,
    /** Speed over ground. */
    SPEED
  }

  /**
   * What is true at one time.
   *
   * @param headingRad clockwise from north [rad]
   * @param speedMps over ground [m/s]
   */
  public record Truth(Geodetic place, double headingRad, double speedMps) {}

  private static final int SIGMAS = 3;
  private static final double SLOWEST_MPS = 0.05;

  private static final class Tally {
    private int count;
    private double squares;
    private double normalised;
    private final int[] within = new int[SIGMAS];

    void add(double error, double sigma) {
      count++;
      squares += error * error;
      normalised += error * error / (sigma * sigma);
      for (int k = 0; k < SIGMAS; k++) {
        within[k] += Math.abs(error) <= (k + 1) * sigma ? 1 : 0;
      }
    }
  }

  private final Map<Quantity, Tally> tallies = new EnumMap<>(Quantity.class);

  /** None yet. */
  public EstimateErrors() {
    for (Quantity each : Quantity.values()) {
      tallies.put(each, new Tally());
    }
  }

  /**
   * Compares a state in GLOBAL with what is true at its time; of a state without position nothing.
   */
  public void add(StateInformation state, Truth truth) {
    if (state.x().isEmpty() || state.psi().isEmpty()) {
      return;
    }
    Geodetic said =
        new Geodetic(state.x().getAsDouble(), state.y().getAsDouble(), truth.place().altitudeM());
    Point apart = truth.place().enuOf(said);
    add(Quantity.X, apart.x(), state.number(StateField.X_SIGMA));
    add(Quantity.Y, apart.y(), state.number(StateField.Y_SIGMA));
    double turn = state.psi().getAsDouble() - truth.headingRad();
    add(
        Quantity.HEADING,
        Math.IEEEremainder(turn, 2.0 * Math.PI),
        state.number(StateField.PSI_SIGMA));
    double vx = state.xDot().orElse(0.0);
    double vy = state.yDot().orElse(0.0);
    double speed = Math.hypot(vx, vy);
    if (speed > SLOWEST_MPS) {
      double sx = vx / speed * state.number(StateField.X_DOT_SIGMA).orElseThrow();
      double sy = vy / speed * state.number(StateField.Y_DOT_SIGMA).orElseThrow();
      add(Quantity.SPEED, speed - truth.speedMps(), OptionalDouble.of(Math.hypot(sx, sy)));
    }
  }

  private void add(Quantity quantity, double error, OptionalDouble sigma) {
    tallies.get(quantity).add(error, sigma.orElseThrow());
  }

  /** Share of errors within that many of the claimed standard deviations (1, 2 or 3). */
  public double within(Quantity quantity, int sigmas) {
    Tally tally = tallies.get(quantity);
    return tally.within[sigmas - 1] / (double) tally.count;
  }

  /** Mean of the squared error over the claimed variance: 1 of an honest estimate. */
  public double normalisedSquare(Quantity quantity) {
    Tally tally = tallies.get(quantity);
    return tally.normalised / tally.count;
  }

  /** Root of the mean squared error [m, rad or m/s]. */
  public double rms(Quantity quantity) {
    Tally tally = tallies.get(quantity);
    return Math.sqrt(tally.squares / tally.count);
  }

  /** Rows of the table in docs/state-estimation.md, into {@code target/} of the module. */
  public void report(String what) throws IOException {
    StringBuilder rows = new StringBuilder();
    for (Quantity each : Quantity.values()) {
      boolean isAngle = each == Quantity.HEADING;
      rows.append(
          String.format(
              Locale.ROOT,
              "| %s | %s | %.3f%s | %.0f %% | %.0f %% | %.0f %% | %.2f |%n",
              what,
              each.name().toLowerCase(Locale.ROOT),
              isAngle ? Math.toDegrees(rms(each)) : rms(each),
              isAngle ? "°" : each == Quantity.SPEED ? " m/s" : " m",
              100.0 * within(each, 1),
              100.0 * within(each, 2),
              100.0 * within(each, 3),
              normalisedSquare(each)));
    }
    Path folder = Files.createDirectories(Path.of("target"));
    Files.writeString(
        folder.resolve("estimate-errors.txt"),
        rows,
        StandardOpenOption.CREATE,
        StandardOpenOption.APPEND);
  }
}
