/** Log files of services. SLF4J output of libraries is not handled here. */
package org.u2sa.interfaces.log;
