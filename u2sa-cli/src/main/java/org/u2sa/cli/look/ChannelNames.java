package org.u2sa.cli.look;

import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.xml.NearestNames;

/** Channels by user-entered name; iterates over the standard channels for completion. */
public final class ChannelNames implements Iterable<String> {
  private static List<String> standard() {
    return Channels.all().stream().map(Channel::name).collect(Collectors.toList());
  }

  /**
   * Channel with this name; a non-standard one carries any data.
   *
   * @throws BadInputException if the name is invalid
   */
  public static Channel<?> channel(String name) {
    try {
      return Channels.namedOrNew(name);
    } catch (IllegalArgumentException e) {
      throw new BadInputException(e.getMessage() + NearestNames.didYouMean(name, standard()), e);
    }
  }

  /** Error message for a channel on which nothing was received. */
  static String nothingHeard(Channel<?> channel, String system, double seconds) {
    boolean known = Channels.named(channel.name()).isPresent();
    return String.format(
        Locale.ROOT,
        "nothing received on \"%s\" of system \"%s\" within %.1f s%s",
        channel,
        system,
        seconds,
        known ? "" : NearestNames.didYouMean(channel.name(), standard()));
  }

  @Override
  public Iterator<String> iterator() {
    return standard().iterator();
  }
}
