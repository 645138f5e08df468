/**
 * A service with a message of its own, to which docs/extending.md points. Tests of the framework
 * itself do not belong here.
 */
package org.u2sa.examples;
