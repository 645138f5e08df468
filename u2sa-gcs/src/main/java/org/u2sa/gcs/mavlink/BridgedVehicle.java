package org.u2sa.gcs.mavlink;

import java.util.Optional;
import java.util.function.LongSupplier;
import org.u2sa.gcs.mavlink.event.VehicleEvents;
import org.u2sa.gcs.mavlink.file.ComponentMetadataFiles;
import org.u2sa.gcs.mavlink.file.OfferedFiles;
import org.u2sa.gcs.mavlink.file.RecordingFolder;
import org.u2sa.gcs.mavlink.plan.FenceBook;
import org.u2sa.gcs.mavlink.plan.MissionProgressMessages;
import org.u2sa.gcs.mavlink.plan.PlanBook;
import org.u2sa.gcs.mavlink.telemetry.FollowedRoute;
import org.u2sa.gcs.mavlink.telemetry.Placement;
import org.u2sa.gcs.mavlink.telemetry.Telemetry;
import org.u2sa.gcs.mavlink.telemetry.Uptime;
import org.u2sa.gcs.mavlink.vehicle.Identity;
import org.u2sa.gcs.mavlink.vehicle.OrdersUnderWay;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;
import org.u2sa.gcs.mavlink.vehicle.VehicleStatus;
import org.u2sa.gcs.mavlink.vehicle.VehicleSurroundings;

/** The vehicle and its identity, shared by all stations of a bridge. */
final class BridgedVehicle {
  final OrdersUnderWay orders;
  final VehicleStatus model;
  final VehicleSurroundings surroundings;
  final FollowedRoute route;
  final Identity identity;
  final String systemId;
  final int mavlinkId;
  final Placement placement;
  final Uptime uptime;
  final PlanBook book;
  final FenceBook fences;
  final MissionProgressMessages progress;
  final Telemetry telemetry;
  final OfferedFiles files;
  final VehicleEvents events;

  /**
   * @param systemId the vehicle's U2SA system ID
   * @param mavlinkId the vehicle's MAVLink system ID
   * @param recordings folder whose recordings stations may download; empty: none
   * @param clock real time [µs since 1970]
   */
  BridgedVehicle(
      OrdersUnderWay orders,
      Identity identity,
      Optional<VehicleKind> kind,
      String systemId,
      int mavlinkId,
      Optional<RecordingFolder> recordings,
      LongSupplier clock) {
    this.orders = orders;
    this.identity = identity;
    this.systemId = systemId;
    this.mavlinkId = mavlinkId;
    model = new VehicleStatus(clock, kind, orders);
    placement = new Placement(model);
    uptime = new Uptime(clock);
    book = new PlanBook(model, placement, identity);
    fences = new FenceBook(model, placement);
    surroundings = new VehicleSurroundings(clock);
    progress = new MissionProgressMessages(model, book);
    telemetry = new Telemetry(model, identity, placement, uptime);
    telemetry.add(surroundings, placement, uptime);
    route = new FollowedRoute(model, clock);
    telemetry.add(model, route, placement);
    events = new VehicleEvents(model, uptime);
    telemetry.add(Telemetry.CURRENT_EVENT_SEQUENCE, 1.0, events::sequence);
    telemetry.add(Telemetry.MISSION_CURRENT, 1.0, progress::current);
    ComponentMetadataFiles metadata =
        new ComponentMetadataFiles(model.configurations(), systemId, uptime);
    telemetry.add(Telemetry.COMPONENT_METADATA, 0.0, metadata::message);
    files = new OfferedFiles(metadata, recordings);
  }
}
