/**
 * Finding services by what they offer instead of by name (thesis 3.2.2.1, user story 7), for
 * services and tools alike. Transport of requests and messages is elsewhere.
 */
package org.u2sa.service.directory;
