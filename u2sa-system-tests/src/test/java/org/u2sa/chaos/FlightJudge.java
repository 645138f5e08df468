package org.u2sa.chaos;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.u2sa.flightgear.protocol.OutField;
import org.u2sa.flightgear.protocol.OutLine;
import org.u2sa.interfaces.time.Clock;

/**
 * Watches the true flight, on a thread of its own: nothing that is broken may cost the aircraft.
 */
final class FlightJudge implements AutoCloseable {
  private static final double AIRBORNE_M = 400.0; // the mission's legs are at 450 m
  private static final double SAFE_M = 250.0;
  private static final double UPRIGHT_RAD = Math.toRadians(40.0);
  private static final double LOWEST_M = 60.0;
  private static final double SLOWEST_MPS = 26.0; // stall at 1.0 g, flaps up: 24.5 m/s

  /**
   * Longest time below that. FlightGear keeps its last controls while the Simulator's process hangs
   * or is frozen: elevator that belonged to a turn zooms the aircraft until somebody takes over.
   */
  private static final double SLOW_AT_MOST_S = 10.0;

  private static final double STEEPEST_RAD = Math.toRadians(60.0);
  private static final long EVERY_MICROS = 50_000;

  private final Vehicle vehicle;
  private final Clock clock;
  private final Thread thread = new Thread(this::watch, "flight-judge");
  private final List<String> violations = new ArrayList<>();
  private final StringBuilder track = new StringBuilder("time,x,y,z,airspeed,bankDeg\n");
  private boolean airborne;
  private double lowestM = Double.POSITIVE_INFINITY;
  private double slowestMps = Double.POSITIVE_INFINITY;
  private double steepestRad;
  private double flyingS; // when it was fast enough last

  FlightJudge(Vehicle vehicle, Clock clock) {
    this.vehicle = vehicle;
    this.clock = clock;
    thread.setDaemon(true);
    thread.start();
  }

  private void watch() {
    try (Clock.Waiter waiter = clock.newWaiter("flight-judge")) {
      while (!Thread.currentThread().isInterrupted()) {
        look(vehicle.truth());
        waiter.await(clock.micros() + EVERY_MICROS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private synchronized void look(OutLine truth) {
    double heightM = truth.get(OutField.HEIGHT);
    double airspeed = truth.get(OutField.CALIBRATED_AIRSPEED);
    double bank = Math.abs(truth.get(OutField.ROLL));
    track.append(
        String.format(
            Locale.ROOT,
            "%.2f,%.6f,%.6f,%.1f,%.1f,%.1f%n",
            truth.get(OutField.ELAPSED),
            truth.get(OutField.LONGITUDE),
            truth.get(OutField.LATITUDE),
            truth.get(OutField.ALTITUDE),
            airspeed,
            Math.toDegrees(truth.get(OutField.ROLL))));
    airborne |= heightM > AIRBORNE_M;
    if (!airborne) {
      flyingS = truth.get(OutField.ELAPSED);
      return;
    }
    lowestM = Math.min(lowestM, heightM);
    slowestMps = Math.min(slowestMps, airspeed);
    double elapsedS = truth.get(OutField.ELAPSED);
    flyingS = airspeed < SLOWEST_MPS ? flyingS : elapsedS;
    steepestRad = Math.max(steepestRad, bank);
    if (truth.isSet(OutField.CRASHED) || truth.isSet(OutField.WEIGHT_ON_WHEEL)) {
      violation("touched the ground");
    } else if (heightM < LOWEST_M) {
      violation("sank to " + (int) heightM + " m");
    } else if (elapsedS - flyingS > SLOW_AT_MOST_S) {
      violation("was slow for " + (int) (elapsedS - flyingS) + " s");
    } else if (bank > STEEPEST_RAD) {
      violation("banked " + (int) Math.toDegrees(bank) + " deg");
    }
  }

  private void violation(String what) {
    if (violations.size() < 20) {
      violations.add(
          String.format(Locale.ROOT, "%s at %.1f s", what, vehicle.truth().get(OutField.ELAPSED)));
    }
  }

  synchronized boolean isAirborne() {
    return airborne;
  }

  /** Whether the aircraft is where the next mishap cannot bring it down. */
  boolean isSafe() {
    OutLine truth = vehicle.truth();
    return truth.get(OutField.HEIGHT) > SAFE_M && Math.abs(truth.get(OutField.ROLL)) < UPRIGHT_RAD;
  }

  /** What the aircraft must not do and did. */
  synchronized List<String> violations() {
    return List.copyOf(violations);
  }

  synchronized String extremes() {
    return String.format(
        Locale.ROOT,
        "lowest %.0f m, slowest %.1f m/s, steepest %.0f deg",
        lowestM,
        slowestMps,
        Math.toDegrees(steepestRad));
  }

  /** The flown track as CSV. */
  synchronized String track() {
    return track.toString();
  }

  @Override
  public void close() {
    thread.interrupt();
  }
}
