package org.u2sa.core.communication.access;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.ByteBufUtil;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.u2sa.core.security.AccessRule;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;

/**
 * Assigns source names to connections: the first connection to publish under a name owns it until
 * it closes, or until another connection from the same sender takes over. A reconnecting or
 * restarted service is therefore never locked out by its own half-open connection, and a silent
 * connection loses its names to other senders.
 *
 * <p>The vehicle, i.e. the broker's process and the processes that it started, takes any name from
 * others. A name under which a service of the vehicle has reported health stays reserved until that
 * service reports that it has stopped, so that nobody can impersonate a failed service. The arming
 * state stays reserved permanently, because actuators would believe an impostor while the Safety
 * Manager restarts.
 *
 * <p>Failsafes have two writers, which may belong to different runs: the Safety Manager and, while
 * that is lost, the Health Monitor. Their names have no owner: they are accepted from the vehicle,
 * from clients that may publish the arming state, and from the sender that runs the monitor.
 *
 * <p>For the network's thread only, except where stated otherwise.
 */
public final class SourceNames {
  /** Reason for refusing a message whose source name is taken. */
  public static final String TAKEN = "its source name belongs to another connection";

  private static final int MAX_HELD = 4_096; // per connection; names beyond it have no owner

  private final MessageCodec codec;
  private final Map<String, Speaker> speakers = new HashMap<>(); // by key
  private final Set<String> vehicles = ConcurrentHashMap.newKeySet(); // keys kept for the vehicle
  private final HealthMonitors monitors = new HealthMonitors();
  private volatile LocalBus bus; // null until joined

  /**
   * @param codec reads the names
   */
  public SourceNames(MessageCodec codec) {
    this.codec = codec;
  }

  /** Sets the bus of the services in the broker's process, which own their source names. */
  public void join(LocalBus services) {
    bus = services;
  }

  /** Records a message from a service in the broker's process. Thread-safe. */
  public void hearLocal(Channel<?> channel, U2SAData message) {
    LocalBus services = bus;
    if (services == null) {
      return;
    }
    if (message instanceof ArmingState) {
      keep(SourceName.key(services.systemId(), channel.name(), ""), false);
    } else if (message instanceof ServiceCondition) {
      monitors.hearVehicle(services.systemId());
    } else if (message instanceof HealthReport report
        && !(message instanceof ConnectionLost)) { // it reports on another service
      keep(
          SourceName.key(services.systemId(), "", report.serviceName()),
          report.status() == ServiceStatus.STOPPED);
    }
  }

  private void keep(String key, boolean isLast) {
    if (isLast) {
      vehicles.remove(key);
    } else if (!vehicles.contains(key)) { // reading is cheaper than writing
      vehicles.add(key);
    }
  }

  /** Source of a message; empty if anyone with permission may publish it. */
  public Optional<SourceName> nameOf(Topic topic, AccessRule rule, ByteBuf payload) {
    return SourceName.of(topic, rule, payload, codec);
  }

  /** Whether a connection may publish a message; if so, it becomes the owner of the source name. */
  public boolean mayPublish(
      Topic topic, AccessRule rule, ByteBuf payload, Speaker speaker, long nowMicros) {
    Optional<SourceName> source = nameOf(topic, rule, payload);
    if (source.isEmpty()) {
      return true;
    }
    if (source.get().isOf(Channels.FAILSAFE)) {
      return mayDemandFailsafe(topic.systemId(), speaker, nowMicros);
    }
    boolean may = mayUse(source.get(), speaker, nowMicros);
    if (may && source.get().isOf(Channels.CONDITIONS)) {
      monitors.hear(topic.systemId(), speaker, nowMicros);
    } else if (may && speaker.isOfVehicle() && source.get().isOf(Channels.ARMING_STATE)) {
      keep(source.get().key(), false);
    } else if (may && speaker.isOfVehicle() && source.get().isOf(Channels.HEALTH)) {
      Optional<String> status = codec.peek(ByteBufUtil.getBytes(payload), "status");
      keep(source.get().key(), status.equals(Optional.of(ServiceStatus.STOPPED.name())));
    }
    return may;
  }

  /** Whether a service of the vehicle has reported under the name. Thread-safe. */
  public boolean isOfVehicle(String systemId, String serviceName) {
    return vehicles.contains(SourceName.key(systemId, "", serviceName));
  }

  private boolean mayDemandFailsafe(String systemId, Speaker speaker, long nowMicros) {
    SourceName manager = SourceName.ofOnlyWriter(systemId, Channels.ARMING_STATE);
    boolean may =
        speaker.isOfVehicle()
            || monitors.isRunBy(systemId, speaker)
            || !isOfVehicle(manager) && speaker.mayReplace(speakers.get(manager.key()), nowMicros);
    if (may) {
      speaker.spoke(nowMicros);
    }
    return may;
  }

  private boolean mayUse(SourceName name, Speaker speaker, long nowMicros) {
    if (!speaker.isOfVehicle() && isOfVehicle(name)) {
      return false;
    }
    Speaker holder = speakers.get(name.key());
    if (holder != speaker && !speaker.mayReplace(holder, nowMicros)) {
      return false;
    }
    speaker.spoke(nowMicros);
    if (holder != speaker) {
      hold(name.key(), holder, speaker);
    }
    return true;
  }

  private boolean isOfVehicle(SourceName name) {
    LocalBus services = bus;
    return vehicles.contains(name.key())
        || !name.isService()
            && services != null
            && services.systemId().equals(name.systemId())
            && (name.isOfOnlyWriter()
                ? services.isPublished(name.channel())
                : services.isLocal(name.channel(), name.name()));
  }

  private void hold(String key, Speaker before, Speaker speaker) {
    if (before != null) {
      before.held().remove(key);
      speakers.remove(key);
    }
    if (speaker.held().size() < MAX_HELD) {
      speaker.held().add(key);
      speakers.put(key, speaker);
    }
  }

  /** Frees the names of a connection that has ended. */
  public void leave(Speaker speaker) {
    speaker.held().forEach(key -> speakers.remove(key, speaker));
    speaker.held().clear();
  }
}
