/**
 * The root of the contract that every service fulfils (thesis 3.2.1); here is only what reports bad
 * input. Configuration, logging, time, communication and XML have a package each; anything that
 * knows a vehicle belongs elsewhere.
 */
package org.u2sa.interfaces;
