package org.u2sa.gcs.services;

import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.service.directory.DataOffer;
import org.u2sa.service.directory.KnownService;
import org.u2sa.service.directory.ServiceDirectory;

/** The type of data that an operator names. */
final class DataType {
  private DataType() {}

  /**
   * The type and its ancestors, base first: of a type known here, or of one that some service
   * named.
   *
   * @throws BadInputException if nobody knows it; names those that are near
   */
  static List<String> chain(String name, ServiceDirectory directory) {
    Optional<MessageType<?>> known = MessageTypes.discovered().byName(name);
    if (known.isPresent()) {
      return known.get().chain();
    }
    SortedSet<String> names = new TreeSet<>();
    for (MessageType<?> type : MessageTypes.discovered().all()) {
      names.add(type.name());
    }
    for (KnownService service : directory.services()) {
      for (List<DataOffer> offers : List.of(service.publishes(), service.subscribes())) {
        for (DataOffer offer : offers) {
          int at = offer.typeChain().indexOf(name);
          if (at >= 0) {
            return offer.typeChain().subList(0, at + 1);
          }
          names.addAll(offer.typeChain());
        }
      }
    }
    throw new BadInputException(
        "no data of type \""
            + name
            + "\" is known here or to any service"
            + NearestNames.didYouMean(name, names));
  }
}
