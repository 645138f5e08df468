package org.u2sa.estimation.measurement;

import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import org.u2sa.messages.InertialMeasurement;
import org.u2sa.messages.LandmarkSighting;
import org.u2sa.messages.SensorParts;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * Converts a message to a measurement from the message alone (thesis 5.1): the presence vector
 * defines the fields, the frame the axes, and the sigmas the accuracy. Accelerations over ground,
 * and position and attitude in body frames, are not used.
 */
public final class MeasurementReader {
  private static final double MIN_SIGMA = 1e-3; // no measurement is perfect
  private static final double MIN_ANGLE = 1e-4;

  private static final StateField[] POSITION = {StateField.X, StateField.Y, StateField.Z};
  private static final StateField[] POSITION_SIGMA = {
    StateField.X_SIGMA, StateField.Y_SIGMA, StateField.Z_SIGMA
  };
  private static final StateField[] VELOCITY = {
    StateField.X_DOT, StateField.Y_DOT, StateField.Z_DOT
  };
  private static final StateField[] VELOCITY_SIGMA = {
    StateField.X_DOT_SIGMA, StateField.Y_DOT_SIGMA, StateField.Z_DOT_SIGMA
  };
  private static final StateField[] RATES = {
    StateField.PHI_DOT, StateField.THETA_DOT, StateField.PSI_DOT
  };
  private static final StateField[] RATE_SIGMAS = {
    StateField.PHI_DOT_SIGMA, StateField.THETA_DOT_SIGMA, StateField.PSI_DOT_SIGMA
  };
  private static final StateField[] FLUID = {
    StateField.FLUID_X_DOT, StateField.FLUID_Y_DOT, StateField.FLUID_Z_DOT
  };
  private static final StateField[] FLUID_SIGMA = {
    StateField.FLUID_X_DOT_SIGMA, StateField.FLUID_Y_DOT_SIGMA, StateField.FLUID_Z_DOT_SIGMA
  };

  private static final int MAX_INERTIAL = 64; // caps memory against spoofed sensors

  private final UsualSigmas usual;
  private final Set<String> fluidSensors;
  private final Set<String> inertialSensors = new TreeSet<>(); // sensor names

  /** Creates a reader for all sensors that uses the given sigmas if a message has none. */
  public MeasurementReader(UsualSigmas usual) {
    this(usual, new TreeSet<>());
  }

  /**
   * Creates a reader that uses the given sigmas if a message has none.
   *
   * @param fluidSensors names of the sensors whose speeds through the fluid count; empty: all
   */
  public MeasurementReader(UsualSigmas usual, Set<String> fluidSensors) {
    this.usual = usual;
    this.fluidSensors = new TreeSet<>(fluidSensors);
  }

  /**
   * Reads a message.
   *
   * @param message message, which must have a timestamp
   * @throws IllegalArgumentException if it cannot be converted, such as an x without a y on a grid
   */
  public Measurement read(StateInformation message, Measurement to) {
    to.begin(message.sensorName(), message.timestamp().orElseThrow());
    if (message instanceof LandmarkSighting seen) {
      readLandmark(seen, to);
      return to;
    }
    ReferenceFrame frame = message.referenceFrame();
    if (frame.isBody()) {
      readBody(message.in(ReferenceFrame.BODY_FRD), to);
    } else if (frame.isLocal()) {
      readLocal(message.in(ReferenceFrame.LOCAL_NED), to);
    } else {
      readGlobal(message.in(ReferenceFrame.GLOBAL), to);
    }
    return to;
  }

  private double sigma(StateInformation s, StateField field, double ifAbsent) {
    OptionalDouble claimed = s.number(field);
    boolean isAngle = field.ordinal() >= StateField.PHI_SIGMA.ordinal();
    return honest(claimed, ifAbsent, isAngle ? MIN_ANGLE : MIN_SIGMA);
  }

  /** Replaces a zero or negative sigma by the default and enforces a minimum. */
  private static double honest(OptionalDouble claimed, double ifAbsent, double least) {
    double sigma = claimed.orElse(ifAbsent);
    return Math.max(least, sigma > 0.0 ? sigma : ifAbsent);
  }

  private void readGlobal(StateInformation s, Measurement to) {
    double east = sigma(s, StateField.X_SIGMA, usual.position());
    double north = sigma(s, StateField.Y_SIGMA, usual.position());
    s.y().ifPresent(y -> to.set(SensedQuantity.PLACE, 0, Math.toRadians(y), north));
    s.x().ifPresent(x -> to.set(SensedQuantity.PLACE, 1, Math.toRadians(x), east));
    s.z().ifPresent(z -> to.altitude(z, sigma(s, StateField.Z_SIGMA, usual.position())));
    int[] nedFromEnu = {1, 0, 2};
    for (int i = 0; i < 3; i++) {
      int axis = nedFromEnu[i];
      OptionalDouble velocity = s.number(VELOCITY[axis]);
      if (velocity.isPresent()) {
        double down = i == 2 ? -velocity.getAsDouble() : velocity.getAsDouble();
        to.set(SensedQuantity.VELOCITY, i, down, sigma(s, VELOCITY_SIGMA[axis], usual.velocity()));
      }
    }
    readAttitude(s, to);
    readFluid(s, to, -1.0);
  }

  private void readLocal(StateInformation s, Measurement to) {
    for (int i = 0; i < 3; i++) {
      OptionalDouble position = s.number(POSITION[i]);
      if (position.isPresent()) {
        SensedQuantity quantity = i < 2 ? SensedQuantity.LOCAL_PLACE : SensedQuantity.LOCAL_DOWN;
        double sigma = sigma(s, POSITION_SIGMA[i], usual.position());
        to.set(quantity, i % 2, position.getAsDouble(), sigma);
      }
    }
    vector(s, to, SensedQuantity.VELOCITY, VELOCITY, VELOCITY_SIGMA, usual.velocity());
    readAttitude(s, to);
    readFluid(s, to, -1.0);
  }

  private void readBody(StateInformation s, Measurement to) {
    vector(s, to, SensedQuantity.BODY_VELOCITY, VELOCITY, VELOCITY_SIGMA, usual.velocity());
    readRates(s, to);
    readFluid(s, to, 1.0);
    if (s instanceof InertialMeasurement inertial) {
      readInertial(inertial, to);
    }
  }

  private void readAttitude(StateInformation s, Measurement to) {
    double rollSigma = sigma(s, StateField.PHI_SIGMA, usual.attitude());
    double pitchSigma = sigma(s, StateField.THETA_SIGMA, usual.attitude());
    s.phi().ifPresent(phi -> to.set(SensedQuantity.TILT, 0, phi, rollSigma));
    s.theta().ifPresent(theta -> to.set(SensedQuantity.TILT, 1, theta, pitchSigma));
    s.psi().ifPresent(psi -> to.heading(psi, sigma(s, StateField.PSI_SIGMA, usual.attitude())));
    readRates(s, to);
  }

  /**
   * Reads Euler rates, except those of a sensor whose gyroscopes are read: they have the same bias,
   * so as independent measurements they would seem to show that there is none.
   */
  private void readRates(StateInformation s, Measurement to) {
    if (!inertialSensors.contains(s.sensorName())) {
      vector(s, to, SensedQuantity.EULER_RATES, RATES, RATE_SIGMAS, usual.rate());
    }
  }

  /** Reads speeds through the fluid; y points left in BODY, right in FRD. */
  private void readFluid(StateInformation s, Measurement to, double ySign) {
    String source = s.sensorName();
    if (!fluidSensors.isEmpty()
        && !fluidSensors.contains(source)
        && !fluidSensors.contains(SensorParts.sensor(source))) {
      return; // speed through a different fluid
    }
    for (int i = 0; i < 3; i++) {
      OptionalDouble speed = s.number(FLUID[i]);
      if (speed.isPresent()) {
        double value = i == 1 ? ySign * speed.getAsDouble() : speed.getAsDouble();
        to.set(SensedQuantity.FLUID_VELOCITY, i, value, sigma(s, FLUID_SIGMA[i], usual.fluid()));
      }
    }
  }

  private void vector(
      StateInformation s,
      Measurement to,
      SensedQuantity quantity,
      StateField[] values,
      StateField[] sigmas,
      double ifAbsent) {
    for (int i = 0; i < 3; i++) {
      OptionalDouble value = s.number(values[i]);
      if (value.isPresent()) {
        to.set(quantity, i, value.getAsDouble(), sigma(s, sigmas[i], ifAbsent));
      }
    }
  }

  private void readLandmark(LandmarkSighting seen, Measurement to) {
    boolean isWhole =
        seen.landmarkX().isPresent()
            && seen.landmarkY().isPresent()
            && seen.range().isPresent()
            && seen.bearing().isPresent();
    ReferenceFrame frame = seen.referenceFrame();
    if (!isWhole || frame.isBody()) {
      throw new IllegalArgumentException(
          "contains no landmark with a position on the earth or in a local frame, range and bearing");
    }
    to.sighting(
        seen.range().getAsDouble(),
        seen.bearing().getAsDouble(),
        honest(seen.rangeSigma(), usual.position(), MIN_SIGMA),
        honest(seen.bearingSigma(), usual.attitude(), MIN_ANGLE));
    LandmarkSighting placed =
        seen.in(frame.isEarth() ? ReferenceFrame.GLOBAL : ReferenceFrame.LOCAL_NED);
    double x = placed.landmarkX().getAsDouble();
    double y = placed.landmarkY().getAsDouble();
    if (frame.isEarth()) {
      to.ofPlace(y, x);
    } else {
      to.ofLocal(x, y);
    }
  }

  private void readInertial(InertialMeasurement m, Measurement to) {
    String source = m.sensorName();
    if (source.endsWith(SensorParts.INERTIAL) && inertialSensors.size() < MAX_INERTIAL) {
      inertialSensors.add(SensorParts.sensor(source));
    }
    double rate = honest(m.angularRateSigma(), usual.rate(), MIN_ANGLE);
    double force = honest(m.specificForceSigma(), usual.force(), MIN_SIGMA);
    m.rollRate().ifPresent(v -> to.set(SensedQuantity.BODY_RATES, 0, v, rate));
    m.pitchRate().ifPresent(v -> to.set(SensedQuantity.BODY_RATES, 1, v, rate));
    m.yawRate().ifPresent(v -> to.set(SensedQuantity.BODY_RATES, 2, v, rate));
    m.specificForceX().ifPresent(v -> to.set(SensedQuantity.SPECIFIC_FORCE, 0, v, force));
    m.specificForceY().ifPresent(v -> to.set(SensedQuantity.SPECIFIC_FORCE, 1, v, force));
    m.specificForceZ().ifPresent(v -> to.set(SensedQuantity.SPECIFIC_FORCE, 2, v, force));
  }
}
