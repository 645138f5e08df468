package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.estimation.rotation.Quaternions;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/** Ranges and bearings of things whose place is known. */
class SightingTest {
  private static final int N = FilterState.N;
  private static final double SMALL = 1e-5;
  private static final Geodetic HOME = new Geodetic(-81.0, 29.0, 0.0);

  private final MeasurementModel model = new MeasurementModel();
  private final Measurement m = new Measurement();

  private static FilterState at(double north, double east, double psi, double roll, double pitch) {
    FilterState s = new FilterState();
    Quaternions.fromEuler(roll, pitch, psi, s.x, FilterState.Q);
    s.x[FilterState.NORTH] = north;
    s.x[FilterState.NORTH + 1] = east;
    s.hasLocal = true;
    s.hasHeading = true;
    s.hasTilt = true;
    return s;
  }

  private double innovation(FilterState s, int row) {
    assertThat(model.look(s, m, SensedQuantity.LANDMARK)).isTrue();
    return model.linear.innovation[row];
  }

  private static void disturb(FilterState s, int error, double by) {
    if (error < 3) {
      s.move(error == 0 ? by : 0.0, error == 1 ? by : 0.0, error == 2 ? by : 0.0);
    } else {
      int axis = error - FilterState.ATTITUDE;
      Quaternions.turnEarth(
          s.x, FilterState.Q, axis == 0 ? by : 0.0, axis == 1 ? by : 0.0, axis == 2 ? by : 0.0);
    }
  }

  @Test
  void look_anyStateAndLandmark_jacobianIsTheDerivative() {
    Random random = new Random(2);
    for (int run = 0; run < 40; run++) {
      double psi = 6.0 * random.nextDouble();
      m.begin("Camera", 0).sighting(5.0, 0.3, 0.1, 0.1);
      m.ofLocal(20.0 * random.nextDouble() - 10.0, 20.0 * random.nextDouble() + 3.0);
      for (int row = 0; row < 2; row++) {
        for (int error : new int[] {0, 1, 2, 6, 7, 8}) {
          FilterState s = at(1.0, -2.0, psi, 0.2, -0.3);
          FilterState moved = at(1.0, -2.0, psi, 0.2, -0.3);
          disturb(moved, error, SMALL);
          double before = innovation(s, row);
          double slope = -Math.IEEEremainder(innovation(moved, row) - before, 6.283185307179586);
          innovation(s, row);
          assertThat(model.linear.h.data[row * N + error])
              .as("row %d, error %d", row, error)
              .isCloseTo(slope / SMALL, within(1e-3));
        }
      }
    }
  }

  @Test
  void look_landmarkAheadToTheRight_isInnovationOfRangeAndBearing() {
    m.begin("Camera", 0).sighting(5.5, 1.0, 0.1, 0.05).ofLocal(4.0, 5.0);
    FilterState s = at(1.0, 1.0, 0.0, 0.0, 0.0); // 3 m north of it, 4 m east
    assertThat(innovation(s, 0)).isCloseTo(0.5, within(1e-12));
    assertThat(innovation(s, 1)).isCloseTo(1.0 - Math.atan2(4.0, 3.0), within(1e-12));
    assertThat(model.linear.variance[0]).as("no doubt of the place").isCloseTo(0.01, within(1e-12));
  }

  @Test
  void look_uncertainPlaceNearTheLandmark_saysLess() {
    m.begin("Camera", 0).sighting(1.0, 0.0, 0.1, 0.05).ofLocal(2.0, 1.0);
    FilterState s = at(1.0, 1.0, 0.0, 0.0, 0.0);
    s.isolate(FilterState.POSITION, 0.25);
    s.isolate(FilterState.POSITION + 1, 0.25);
    innovation(s, 0);
    assertThat(model.linear.variance[0]).isCloseTo(0.01 + 0.25 / 2.0, within(1e-12));
    assertThat(model.linear.variance[1]).isCloseTo(0.0025 + 0.25 / 2.0, within(1e-12));
  }

  @Test
  void look_withoutPlaceOrHeading_isOfNoUse() {
    m.begin("Camera", 0).sighting(1.0, 0.0, 0.1, 0.05).ofPlace(29.0, -81.0);
    FilterState s = at(0.0, 0.0, 0.0, 0.0, 0.0);
    assertThat(model.look(s, m, SensedQuantity.LANDMARK)).as("a place on earth").isFalse();
    m.ofLocal(1.0, 1.0);
    s.hasHeading = false;
    assertThat(model.look(s, m, SensedQuantity.LANDMARK)).isFalse();
  }

  @Test
  void add_twoLandmarksSeenFromAnUnsurePlace_leadToTheTruth() {
    for (boolean isOnEarth : new boolean[] {false, true}) {
      ErrorStateFilter filter =
          new ErrorStateFilter(Tunings.withoutConstraint(MotionDomain.GROUND));
      m.begin("Start", 1_000_000).heading(0.6, 0.2); // truly 0.5, at 0, 0
      if (isOnEarth) {
        Geodetic wrong = HOME.fromNed(Point.of(2.0, -1.5, 0.0));
        m.place(wrong.latitudeDeg(), wrong.longitudeDeg(), 2.0, 2.0);
      } else {
        m.localPlace(2.0, -1.5, 2.0);
      }
      filter.add(m);
      for (int i = 1; i <= 40; i++) {
        double north = i % 2 == 0 ? 10.0 : -3.0;
        double east = i % 2 == 0 ? 2.0 : 12.0;
        double bearing = Math.atan2(east, north) - 0.5;
        m.begin("Camera", 1_000_000 + i * 50_000);
        m.sighting(Math.hypot(north, east), bearing, 0.1, 0.02);
        Geodetic place = HOME.fromNed(Point.of(north, east, 0.0));
        filter.add(
            isOnEarth
                ? m.ofPlace(place.latitudeDeg(), place.longitudeDeg())
                : m.ofLocal(north, east));
      }
      Estimate e = filter.at(3_000_000);
      double[] apart = {e.localM(0), e.localM(1)};
      if (isOnEarth) {
        Point p = HOME.nedOf(new Geodetic(e.longitudeDeg(), e.latitudeDeg(), 0.0));
        apart = new double[] {p.x(), p.y()};
      }
      assertThat(Math.hypot(apart[0], apart[1])).isLessThan(0.25);
      assertThat(e.psi()).isCloseTo(0.5, within(0.04));
      assertThat(e.positionSigmaM(0)).isBetween(0.05, 0.25);
    }
  }
}
