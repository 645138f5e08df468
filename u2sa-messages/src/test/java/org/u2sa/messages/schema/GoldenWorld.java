package org.u2sa.messages.schema;

import java.util.HexFormat;
import java.util.List;
import org.u2sa.messages.AircraftState;
import org.u2sa.messages.CameraImage;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.cbor.ByteString;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.Line;
import org.u2sa.messages.shape.MovingSphere;
import org.u2sa.messages.shape.PointCloud;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.messages.shape.Polygon;
import org.u2sa.messages.shape.Rectangle;
import org.u2sa.messages.shape.Sphere;

/** What the World Modeler brought: shapes, motion of objects, the grid, pictures. */
final class GoldenWorld {
  private static final List<Point> CORNERS =
      List.of(Point.of(0.0, 0.0, 0.0), Point.of(4.0, 0.0, 0.0), Point.of(4.0, 3.0, 0.0));

  private GoldenWorld() {}

  static void addTo(GoldenMessages golden) {
    golden.add("Polygon", seen(new Polygon().points(CORNERS).height(2.5)));
    golden.add("PolyLine", seen(new PolyLine().points(CORNERS).width(0.125).height(1.0)));
    golden.add(
        "MovingSphere", seen(new MovingSphere().radius(150.0).timeStep(0.5).trajectory(CORNERS)));
    golden.add("ObjectDescription-seen", seen(new ObjectDescription()));
    golden.add("PointCloud-seen", seen(new PointCloud()));
    golden.add("Circle-seen", seen(new Circle()));
    golden.add("Rectangle-seen", seen(new Rectangle()));
    golden.add("Line-seen", seen(new Line()));
    golden.add("Sphere-seen", seen(new Sphere()));
    golden.add("Cylinder-seen", seen(new Cylinder()));
    golden.add("Box-seen", seen(new Box()));
    GoldenMarine.addTo(golden);
    golden.add("HealthReport-remarks", remarking(new HealthReport()));
    golden.add("ConnectionLost-remarks", remarking(new ConnectionLost()));
    golden.add(
        "AircraftState",
        new AircraftState()
            .heightAboveGround(1.25)
            .calibratedAirspeed(41.5)
            .engineRpm(2350.0)
            .weightOnWheels(true)
            .engineStarting(true)
            .crashed(true));
    golden.add(
        "CameraImage",
        new CameraImage()
            .sensorName("Camera")
            .format(CameraImage.JPEG)
            .size(640, 480)
            .data(ByteString.copyOf(HexFormat.of().parseHex("ffd8ffe000104a464946007f80ffd9"))));
    golden.add(
        "OccupancyGrid",
        new OccupancyGrid()
            .anchor(ReferenceFrame.LOCAL_NED, Point.of(10.0, 20.0, -0.5))
            .corner(-1.5, 2.0)
            .resolution(0.25)
            .cells(3, new byte[] {OccupancyGrid.UNKNOWN, 0, 20, -20, 127, -127}));
  }

  private static HealthReport remarking(HealthReport report) {
    return report
        .serviceName("WorldModeler")
        .status(ServiceStatus.RUNNING)
        .remarks(List.of("GRID: 12 scans", "OBJECTS: 3 objects"));
  }

  static ObjectDescription seen(ObjectDescription object) {
    object
        .uid("Track 7")
        .objectType("buoy")
        .referenceFrame(ReferenceFrame.LOCAL_ENU)
        .x(4.0)
        .y(8.0)
        .confidence(0.75)
        .sensorName("Radar");
    object
        .motion()
        .velocity(Point.of(1.5, -2.5, 0.5))
        .sigma(Point.of(0.25, 0.5, 1.0))
        .velocitySigma(0.125)
        .horizon(5.0);
    return object;
  }
}
