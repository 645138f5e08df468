package org.u2sa.sim.file;

import java.util.List;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.file.element.FileElement;
import org.u2sa.sim.guide.Carriage;
import org.u2sa.sim.guide.Guide;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;

/** A carriage on a straight guide that is fixed to the ground. */
record FixedBaseModel(Guide guide, double carriageKg, Footprint footprint) implements VehicleModel {
  private static final double LARGEST = 1e9;
  private static final double FAR_M = 10_000.0;

  static FixedBaseModel read(FileElement file, Body body) {
    Guide guide =
        new Guide(
            file.direction("direction"),
            file.number("lowest", "m", -FAR_M, 0.0),
            file.number("highest", "m", 0.0, FAR_M),
            file.positive("force", "N", LARGEST),
            file.number("lag", "s", 0.01, 100.0),
            file.number("drag", "N s/m", 0.0, LARGEST),
            file.number("friction", "N", 0.0, LARGEST, 0.0),
            file.number("brake", "N", 0.0, LARGEST),
            file.number("counterweight", "kg", 0.0, LARGEST, 0.0));
    return new FixedBaseModel(guide, body.massKg(), body.footprint());
  }

  @Override
  public Medium medium() {
    return Medium.GROUND;
  }

  @Override
  public List<String> actuators() {
    return List.of(Carriage.DRIVE);
  }

  @Override
  public SimulatedVehicle make(World world, Point start, double headingRad, long seed) {
    return new Carriage(guide, carriageKg, footprint, world, start, headingRad);
  }
}
