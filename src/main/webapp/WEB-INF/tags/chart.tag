<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="chart" required="true" type="org.toqa.web.page.Chart" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<fmt:message key="statistics.chart.${chart.name()}" var="title"/>
<article class="chart"${chart.isHorizontal() ? ' data-horizontal' : ''}>
  <h2 id="${chart.name()}">${title}</h2>
  <p class="faint"><fmt:message key="statistics.description.${chart.name()}"/></p>
  <c:choose>
    <c:when test="${chart.isEmpty()}"><p class="notice"><fmt:message key="statistics.empty.${chart.name()}"/></p></c:when>
    <c:otherwise>
      <div class="plot"><canvas role="img" aria-labelledby="${chart.name()}"></canvas></div>
      <details open>
        <summary><fmt:message key="statistics.showTable"/></summary>
        <div class="wide-table" role="region" tabindex="0" aria-labelledby="${chart.name()}">
          <table>
            <thead>
              <tr>
                <th scope="col"><fmt:message key="statistics.head.${chart.head()}"/></th>
                <c:forEach items="${chart.columns()}" var="column"><th scope="col" data-column="${column.name()}" data-shape="${column.shape()}" data-unit="${column.unit()}"><fmt:message key="statistics.column.${column.name()}"/></th></c:forEach>
              </tr>
            </thead>
            <tbody>
              <c:forEach items="${chart.rows()}" var="row">
                <tr>
                  <th scope="row"><c:out value="${row.label()}"/></th>
                  <c:forEach items="${row.values()}" var="value" varStatus="at"><td class="number" data-value="${value}"><t:amount value="${value}" unit="${chart.columns()[at.index].unit()}"/></td></c:forEach>
                </tr>
              </c:forEach>
            </tbody>
          </table>
        </div>
      </details>
    </c:otherwise>
  </c:choose>
</article>
