/**
 * Service discovery by data instead of by name (thesis 3.2.2.1, user story 7), for services and
 * tools. Transport of requests and messages is elsewhere.
 */
package org.u2sa.service.directory;
