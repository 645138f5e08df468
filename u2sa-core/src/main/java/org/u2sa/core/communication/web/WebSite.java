package org.u2sa.core.communication.web;

import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import org.u2sa.interfaces.BadInputException;

/** The files of the operator's page, found through {@link ServiceLoader}. */
public interface WebSite {
  /**
   * A file of the page.
   *
   * @param mediaType value of the header Content-Type
   */
  record File(String mediaType, byte[] content) {}

  /** The files by path: "/" is the page, "/map.js" one of its modules. */
  Map<String, File> files();

  /**
   * The only page on the class path.
   *
   * @throws BadInputException if there is none, or several
   */
  static WebSite discovered() {
    try {
      Iterator<WebSite> sites = ServiceLoader.load(WebSite.class).iterator();
      if (!sites.hasNext()) {
        throw new BadInputException("WEB PORT: no operator's page found; it is in u2sa-core");
      }
      WebSite site = sites.next();
      if (sites.hasNext()) {
        throw new BadInputException(
            "WEB PORT: two operator's pages found: "
                + List.of(site.getClass().getName(), sites.next().getClass().getName()));
      }
      return site;
    } catch (ServiceConfigurationError e) {
      throw new BadInputException("WEB PORT: the operator's page cannot be loaded: " + e, e);
    }
  }
}
