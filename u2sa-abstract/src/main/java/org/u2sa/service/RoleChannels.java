package org.u2sa.service;

import java.util.Optional;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.U2SAData;

/** Finds the channel that is meant where an author names only a class of messages. */
final class RoleChannels {
  private RoleChannels() {}

  /** The one of the channels that carries the message and whose type is nearest to its class. */
  static Optional<Channel<?>> nearest(Iterable<Channel<?>> channels, U2SAData data) {
    Channel<?> nearest = null;
    for (Channel<?> channel : channels) {
      if (channel.carries(data) && (nearest == null || depth(channel) > depth(nearest))) {
        nearest = channel;
      }
    }
    return Optional.ofNullable(nearest);
  }

  private static int depth(Channel<?> channel) {
    return channel.type().chain().size();
  }

  /**
   * Where a service of the role publishes messages of the class.
   *
   * @throws IllegalArgumentException if the role has no standard channel for them
   */
  static Channel<?> toPublish(ServiceRole role, Class<? extends U2SAData> dataType) {
    return role.channelToPublish(dataType)
        .orElseThrow(() -> noStandardChannel(role, "publishes", dataType));
  }

  /**
   * Where a service of the role receives messages of the class.
   *
   * @throws IllegalArgumentException if the role has no standard channel for them
   */
  static Channel<?> toSubscribe(ServiceRole role, Class<? extends U2SAData> dataType) {
    return role.channelToSubscribe(dataType)
        .orElseThrow(() -> noStandardChannel(role, "receives", dataType));
  }

  private static IllegalArgumentException noStandardChannel(
      ServiceRole role, String does, Class<? extends U2SAData> dataType) {
    return new IllegalArgumentException(
        "no standard channel on which a "
            + role
            + " "
            + does
            + " "
            + dataType.getSimpleName()
            + ": register with a channel instead, one of "
            + Channels.all()
            + " or your own");
  }
}
