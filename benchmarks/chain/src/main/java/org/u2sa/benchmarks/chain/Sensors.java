package org.u2sa.benchmarks.chain;

import java.util.Random;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.InertialMeasurement;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/**
 * The sensors of a vehicle that drives north at 1 m/s: an IMU at the service's rate, whose measurements are timed, and
 * after it a compass at 50 Hz and a GPS receiver at 10 Hz at most.
 */
final class Sensors extends PeriodicService {
  private static final double COMPASS_HZ = 50.0;
  private static final double GPS_HZ = 10.0;
  private static final double NORTH_DEG = 29.0;
  private static final double EAST_DEG = -81.0;
  private static final double METRES_PER_DEG = 110_852.0; // of latitude, there
  private static final double RATE_SIGMA = 0.001; // [rad/s]
  private static final double FORCE_SIGMA = 0.1; // [m/s^2]
  private static final double HEADING_SIGMA = 0.017; // [rad]
  private static final double PLACE_SIGMA = 0.5; // [m]
  private static final double SPEED_SIGMA = 0.1; // [m/s]

  private final Random random = new Random(1);
  private final Causes causes;
  private final int compassEvery; // steps
  private final int gpsEvery;
  private long steps;
  private volatile long sent; // written by this service's thread only

  Sensors(ServiceContext context, double hz, Causes causes) {
    super(context, ServiceRole.PROPRIOCEPTIVE_SENSOR, "Sensors", hz);
    this.causes = causes;
    compassEvery = (int) Math.max(1, hz / COMPASS_HZ);
    gpsEvery = (int) Math.max(1, hz / GPS_HZ);
    registerPublisher(Channels.SENSED_STATE);
  }

  /** Measurements of the IMU so far. */
  long sent() {
    return sent;
  }

  @Override
  protected void step(double nowS) {
    InertialMeasurement inertial =
        new InertialMeasurement()
            .rollRate(noise(RATE_SIGMA))
            .pitchRate(noise(RATE_SIGMA))
            .yawRate(noise(RATE_SIGMA))
            .angularRateSigma(RATE_SIGMA)
            .specificForceX(noise(FORCE_SIGMA))
            .specificForceY(noise(FORCE_SIGMA))
            .specificForceZ(-9.8 + noise(FORCE_SIGMA))
            .specificForceSigma(FORCE_SIGMA);
    inertial.sensorName("IMU");
    causes.put(inertial, System.nanoTime());
    publish(Channels.SENSED_STATE, inertial);
    if (steps % compassEvery == 0) {
      publish(Channels.SENSED_STATE, heading());
    }
    if (steps % gpsEvery == 0) {
      publish(Channels.SENSED_STATE, fix(steps * periodS()));
    }
    steps++;
    sent = steps;
  }

  private StateInformation heading() {
    double psi = noise(HEADING_SIGMA);
    return new StateInformation()
        .sensorName("Compass")
        .referenceFrame(ReferenceFrame.GLOBAL)
        .psi(psi < 0.0 ? psi + 2.0 * Math.PI : psi)
        .psiSigma(HEADING_SIGMA);
  }

  /** @param drivenM northwards so far [m] */
  private StateInformation fix(double drivenM) {
    return new StateInformation()
        .sensorName("GPS")
        .referenceFrame(ReferenceFrame.GLOBAL)
        .x(EAST_DEG + noise(PLACE_SIGMA) / METRES_PER_DEG)
        .y(NORTH_DEG + (drivenM + noise(PLACE_SIGMA)) / METRES_PER_DEG)
        .z(10.0 + noise(PLACE_SIGMA))
        .xSigma(PLACE_SIGMA)
        .ySigma(PLACE_SIGMA)
        .zSigma(PLACE_SIGMA)
        .xDot(noise(SPEED_SIGMA))
        .yDot(1.0 + noise(SPEED_SIGMA))
        .xDotSigma(SPEED_SIGMA)
        .yDotSigma(SPEED_SIGMA);
  }

  private double noise(double sigma) {
    return sigma * random.nextGaussian();
  }

  /** Where a mission's goal is to lie that is not reached [deg of latitude]. */
  static double farNorthDeg() {
    return NORTH_DEG + 0.1;
  }

  static double eastDeg() {
    return EAST_DEG;
  }
}
