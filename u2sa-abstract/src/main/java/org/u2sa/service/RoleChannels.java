package org.u2sa.service;

import java.util.Optional;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.schema.U2SAData;

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

  /** Why a role has no standard channel for messages of a class, for the log. */
  static String noStandard(ServiceRole role, String does, Class<? extends U2SAData> dataType) {
    return "no standard channel on which a "
        + role
        + " "
        + does
        + " "
        + dataType.getSimpleName()
        + ": register with a channel instead, one of "
        + Channels.all()
        + " or your own";
  }
}
