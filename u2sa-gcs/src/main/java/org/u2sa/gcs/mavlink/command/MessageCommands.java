package org.u2sa.gcs.mavlink.command;

import io.dronefleet.mavlink.common.AutopilotVersion;
import io.dronefleet.mavlink.common.MavProtocolCapability;
import io.dronefleet.mavlink.common.MavResult;
import io.dronefleet.mavlink.common.MessageInterval;
import io.dronefleet.mavlink.minimal.ProtocolVersion;
import io.dronefleet.mavlink.util.EnumValue;
import java.math.BigInteger;
import java.nio.ByteBuffer;
import java.util.Optional;
import org.u2sa.gcs.mavlink.station.GroundStation;
import org.u2sa.gcs.mavlink.telemetry.MessageRates;
import org.u2sa.gcs.mavlink.telemetry.Telemetry;
import org.u2sa.gcs.mavlink.vehicle.Identity;

/** Handles commands that request messages or set their rates. */
public final class MessageCommands {
  private static final int GET_HOME = 410; // MAV_CMD numbers
  private static final int GET_INTERVAL = 510;
  private static final int SET_INTERVAL = 511;
  private static final int REQUEST_MESSAGE = 512;
  private static final int REQUEST_PROTOCOL = 519;
  private static final int REQUEST_CAPABILITIES = 520;
  private static final int PROTOCOL = 200; // MAVLink 2.0
  private static final long SOFTWARE = 0x01_00_00_FFL; // 1.0.0, FIRMWARE_VERSION_TYPE_OFFICIAL
  private static final int HASH_BYTES = 8;
  private static final int UID2_BYTES = 18;

  private final Telemetry telemetry;
  private final MessageRates rates;
  private final Identity identity;
  private final String systemId;
  private final GroundStation station;

  /**
   * @param systemId the vehicle's ID, from which its unique number is derived
   */
  public MessageCommands(
      Telemetry telemetry,
      MessageRates rates,
      Identity identity,
      String systemId,
      GroundStation station) {
    this.telemetry = telemetry;
    this.rates = rates;
    this.identity = identity;
    this.systemId = systemId;
    this.station = station;
  }

  /** Executes a command; empty if it is not one of these. */
  Optional<MavResult> obey(Command command) {
    return switch (command.id()) {
      case GET_HOME -> Optional.of(request(Telemetry.HOME_POSITION, 0));
      case REQUEST_PROTOCOL -> Optional.of(request(Telemetry.PROTOCOL_VERSION, 0));
      case REQUEST_CAPABILITIES -> Optional.of(request(Telemetry.AUTOPILOT_VERSION, 0));
      case REQUEST_MESSAGE -> Optional.of(request((int) command.param1(), (int) command.param2()));
      case SET_INTERVAL ->
          Optional.of(
              rates.set((int) command.param1(), command.param2())
                  ? MavResult.MAV_RESULT_ACCEPTED
                  : MavResult.MAV_RESULT_DENIED);
      case GET_INTERVAL -> {
        int id = (int) command.param1();
        station.send(MessageInterval.builder().messageId(id).intervalUs(rates.get(id)).build());
        yield Optional.of(MavResult.MAV_RESULT_ACCEPTED);
      }
      default -> Optional.empty();
    };
  }

  private MavResult request(int id, int index) {
    switch (id) {
      case Telemetry.AUTOPILOT_VERSION -> station.send(version());
      case Telemetry.PROTOCOL_VERSION -> station.send(protocol());
      case Telemetry.AVAILABLE_MODES -> {
        return modes(index);
      }
      default -> {
        Telemetry.Source source = telemetry.sources().get(id);
        Optional<Object> message = source == null ? Optional.empty() : source.make().get();
        message.ifPresent(station::send);
        return message.isPresent()
            ? MavResult.MAV_RESULT_ACCEPTED
            : source == null
                ? MavResult.MAV_RESULT_UNSUPPORTED
                : MavResult.MAV_RESULT_TEMPORARILY_REJECTED;
      }
    }
    return MavResult.MAV_RESULT_ACCEPTED;
  }

  /** Index 0 asks for all modes. */
  private MavResult modes(int index) {
    if (index < 0 || index > telemetry.modes()) {
      return MavResult.MAV_RESULT_DENIED;
    }
    for (int i = Math.max(1, index); i <= (index == 0 ? telemetry.modes() : index); i++) {
      telemetry.mode(i).ifPresent(station::send);
    }
    return MavResult.MAV_RESULT_ACCEPTED;
  }

  private AutopilotVersion version() {
    int capabilities =
        bit(MavProtocolCapability.MAV_PROTOCOL_CAPABILITY_MISSION_INT)
            | bit(MavProtocolCapability.MAV_PROTOCOL_CAPABILITY_MISSION_FENCE)
            | bit(MavProtocolCapability.MAV_PROTOCOL_CAPABILITY_MISSION_RALLY)
            | bit(MavProtocolCapability.MAV_PROTOCOL_CAPABILITY_COMMAND_INT)
            | bit(MavProtocolCapability.MAV_PROTOCOL_CAPABILITY_FLIGHT_TERMINATION)
            | bit(MavProtocolCapability.MAV_PROTOCOL_CAPABILITY_MAVLINK2)
            | bit(
                identity.castsParameters()
                    ? MavProtocolCapability.MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_C_CAST
                    : MavProtocolCapability.MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_BYTEWISE);
    return AutopilotVersion.builder()
        .capabilities(EnumValue.create(MavProtocolCapability.class, capabilities))
        .flightSwVersion(SOFTWARE)
        .flightCustomVersion(new byte[HASH_BYTES])
        .middlewareCustomVersion(new byte[HASH_BYTES])
        .osCustomVersion(new byte[HASH_BYTES])
        .uid(BigInteger.valueOf(systemId.hashCode() & 0xFFFF_FFFFL))
        .uid2(ByteBuffer.allocate(UID2_BYTES).putInt(systemId.hashCode()).array())
        .build();
  }

  private static int bit(MavProtocolCapability capability) {
    return EnumValue.of(capability).value();
  }

  @SuppressWarnings("deprecation") // stations still ask for it
  private static ProtocolVersion protocol() {
    return ProtocolVersion.builder()
        .version(PROTOCOL)
        .minVersion(PROTOCOL)
        .maxVersion(PROTOCOL)
        .specVersionHash(new byte[HASH_BYTES])
        .libraryVersionHash(new byte[HASH_BYTES])
        .build();
  }
}
