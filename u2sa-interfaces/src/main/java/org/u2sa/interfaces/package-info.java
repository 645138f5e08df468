/**
 * Root of the service contract (thesis 3.2.1); contains only input error reporting, limits of input
 * and text helpers. Configuration, logging, time, communication and XML have their own packages;
 * vehicle-specific code belongs elsewhere.
 */
package org.u2sa.interfaces;
