/**
 * The service that docs/tutorial.md writes, as its reader will have it. Tests of the framework
 * itself do not belong here.
 */
package org.u2sa.examples;
