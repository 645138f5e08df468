package org.u2sa.world.landmark;

import org.u2sa.messages.frame.Point;

/**
 * A landmark of the map: known in advance, or learnt at its first sighting. A learnt landmark keeps
 * the error of the vehicle's pose at that time; averaging more sightings does not reduce it.
 */
final class Landmark {
  private static final int HITS = 6; // number of sightings averaged into the position
  private static final double CORRELATION_S = 5.0; // for the vehicle to drift by as much
  private static final double SHORTEST_S = 0.05;
  private static final double TOO_FAR_SIGMAS = 4.0;

  final String uid;
  final String type;
  private final boolean isKnown;
  private Point place; // [m] from the map's anchor
  private double variance; // of the position, per axis
  private double sightingVariance;
  private int hits;
  private long learntMicros;
  private long usedMicros = Long.MIN_VALUE;

  private Landmark(String uid, String type, boolean isKnown, Point place, double variance) {
    this.uid = uid;
    this.type = type;
    this.isKnown = isKnown;
    this.place = place;
    this.variance = variance;
  }

  static Landmark known(String uid, String type, Point place, double sigma) {
    return new Landmark(uid, type, true, place, sigma * sigma);
  }

  /**
   * @param vehicleVariance variance of the position due to the vehicle's pose alone [m²]
   * @param ownVariance variance of the sighting [m²]
   */
  static Landmark seen(
      String uid, String type, Point at, double vehicleVariance, double ownVariance) {
    Landmark landmark = new Landmark(uid, type, false, at, vehicleVariance);
    landmark.sightingVariance = ownVariance;
    landmark.hits = 1;
    return landmark;
  }

  boolean isKnown() {
    return isKnown;
  }

  boolean isLearnt() {
    return isKnown || hits >= HITS;
  }

  /** Averages another sighting while learning; a contradicting one restarts learning. */
  void learn(Point at, double vehicleVariance, double ownVariance, long micros) {
    double away = at.distanceTo(place);
    if (away * away > TOO_FAR_SIGMAS * TOO_FAR_SIGMAS * (variance + 2.0 * ownVariance)) {
      place = at;
      hits = 0;
      variance = vehicleVariance;
    }
    hits++;
    place =
        Point.of(
            place.x() + (at.x() - place.x()) / hits, place.y() + (at.y() - place.y()) / hits, 0.0);
    variance = Math.max(variance, vehicleVariance);
    sightingVariance = ownVariance;
    learntMicros = micros;
  }

  Point place() {
    return place;
  }

  /** Variance of the position per axis [m²]. */
  double variance() {
    return variance + (isKnown || hits == 0 ? 0.0 : sightingVariance / hits);
  }

  /** Time of the last sighting averaged into the position [µs]. */
  long learntMicros() {
    return learntMicros;
  }

  /**
   * Records a use and returns the variance [m²] that the landmark's position contributes to the
   * measurement. The position error is constant, so all uses within two correlation times together
   * carry no more information than one (Brown and Hwang, 3rd ed., section 5.3).
   *
   * @param shared number of learnt landmarks, which share the vehicle's error
   */
  double use(long micros, int shared) {
    if (isKnown) {
      return variance;
    }
    double since = usedMicros == Long.MIN_VALUE ? CORRELATION_S : (micros - usedMicros) * 1e-6;
    usedMicros = micros;
    double repeats = 1.0 + 2.0 * CORRELATION_S / Math.max(SHORTEST_S, since);
    return variance() * repeats * Math.max(1, shared);
  }
}
