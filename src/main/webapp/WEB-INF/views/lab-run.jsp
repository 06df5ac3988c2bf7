<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<c:set var="run" value="${view.run()}"/>
<c:set var="api" value="${root}/api/v1/laboratory/runs/${run.id()}"/>
<fmt:message key="laboratory.run" var="title"><fmt:param>${run.id()}</fmt:param></fmt:message>
<t:page title="${title}" here="laboratory" script="laboratory/laboratory.js">
  <div class="heading" data-run="${run.id()}" data-run-state="${run.state()}">
    <div>
      <h1>${title}${" "}<small><t:english text="${run.order().experiment()}"/></small></h1>
      <p><t:english text="${view.title()}"/></p>
      <p class="run-state"><t:lab-state view="${view}"/></p>
    </div>
    <div class="choices">
      <a href="${root}/laboratory"><fmt:message key="laboratory.all"/></a>
      <c:if test="${not caller.isVisitor()}">
        <c:choose>
          <c:when test="${not view.isOver()}"><form method="post" action="${root}/laboratory/runs/${run.id()}/stop"><t:csrf/><button class="outline"><fmt:message key="laboratory.stop"/></button></form></c:when>
          <c:otherwise>
            <details>
              <summary role="button" class="outline"><fmt:message key="laboratory.delete"/></summary>
              <form method="post" action="${root}/laboratory/runs/${run.id()}/delete"><t:csrf/><p><fmt:message key="laboratory.delete.sure"/></p><button class="danger"><fmt:message key="laboratory.delete.submit"/></button></form>
            </details>
          </c:otherwise>
        </c:choose>
      </c:if>
    </div>
  </div>
  <t:texts keys="laboratory.play laboratory.pause laboratory.seconds"/>
  <t:errors/>
  <c:if test="${run.state() == 'FAILED'}"><p class="notice bad"><t:english text="${run.detail()}"/></p></c:if>
  <c:if test="${run.state() == 'BROKEN_OFF'}"><p class="notice"><fmt:message key="laboratory.brokenOff"/></p></c:if>
  <c:if test="${not view.isOver()}"><p class="notice"><fmt:message key="laboratory.goesOn"/></p></c:if>
  <dl class="facts">
    <div><dt><fmt:message key="laboratory.seed"/></dt><dd><bdi>${run.order().seed()}</bdi></dd></div>
    <div><dt><fmt:message key="laboratory.runs"/></dt><dd><bdi>${run.order().runs()}</bdi></dd></div>
    <div><dt><fmt:message key="laboratory.column.user"/></dt><dd><bdi><c:out value="${run.user()}"/></bdi></dd></div>
    <div><dt><fmt:message key="laboratory.column.ordered"/></dt><dd><t:time at="${run.orderedAt()}"/></dd></div>
    <c:if test="${not empty run.startedAt()}"><div><dt><fmt:message key="laboratory.started"/></dt><dd><t:time at="${run.startedAt()}"/></dd></div></c:if>
    <c:if test="${not empty run.endedAt()}"><div><dt><fmt:message key="laboratory.ended"/></dt><dd><t:time at="${run.endedAt()}"/></dd></div></c:if>
    <c:forEach items="${run.order().values()}" var="value"><div><dt><t:english text="${value.key}"/></dt><dd><bdi>${value.value}</bdi></dd></div></c:forEach>
  </dl>
  <c:if test="${not empty report}">
    <section class="choices downloads">
      <a href="${api}/report" role="button" class="outline" download="toqa-${run.order().experiment()}-${run.id()}.json"><fmt:message key="laboratory.download.report"/></a>
      <c:if test="${not empty report.figures()}"><a href="${api}/figures.csv" role="button" class="outline" download><fmt:message key="laboratory.download.figures"/></a></c:if>
    </section>
    <c:if test="${not empty report.figures()}">
    <h2 id="figures"><fmt:message key="laboratory.figures"/></h2>
    <table class="stacks figures-table">
      <thead><tr><c:forTokens items="figure,published,measured,bound,verdict,reason" delims="," var="column"><th scope="col"><fmt:message key="laboratory.column.${column}"/></th></c:forTokens></tr></thead>
      <tbody>
        <c:forEach items="${report.figures()}" var="figure">
          <tr>
            <th scope="row"><t:english text="${figure.name()}"/></th>
            <td data-label="<fmt:message key="laboratory.column.published"/>"><t:english text="${figure.published().text()}"/></td>
            <td data-label="<fmt:message key="laboratory.column.measured"/>"><t:english text="${figure.measured().text()}"/></td>
            <td data-label="<fmt:message key="laboratory.column.bound"/>"><t:english text="${figure.bound().text()}"/></td>
            <td data-label="<fmt:message key="laboratory.column.verdict"/>"><t:lab-verdict verdict="${figure.verdict()}"/></td>
            <td class="whole"><t:english text="${figure.reason()}"/></td>
          </tr>
        </c:forEach>
      </tbody>
    </table>
    </c:if>
    <h2><fmt:message key="laboratory.drawings"/></h2>
    <div class="charts">
      <c:forEach items="${drawings}" var="drawing">
        <article class="drawing"${drawing.moving() ? ' data-motion="api/v1/laboratory/runs/'.concat(run.id()).concat('/scenes/').concat(drawing.name()).concat('"') : ''}>
          <h3><t:english text="${drawing.title()}"/></h3>
          <div class="stage"><img src="${api}/drawings/${drawing.name()}" alt="" loading="lazy"></div>
          <p><a href="${api}/drawings/${drawing.name()}" download="toqa-${run.order().experiment()}-${run.id()}-${drawing.name()}.svg"><fmt:message key="laboratory.download.svg"/></a></p>
        </article>
      </c:forEach>
    </div>
    <c:forEach items="${report.tables()}" var="table">
      <article class="chart">
        <h2 id="table-${table.name()}"><t:english text="${table.title()}"/></h2>
        <div class="wide-table" role="region" tabindex="0" aria-labelledby="table-${table.name()}" lang="en" dir="ltr">
          <table>
            <thead><tr><c:forEach items="${table.columns()}" var="column"><th scope="col"><c:out value="${column}"/></th></c:forEach></tr></thead>
            <tbody>
              <c:forEach items="${table.rows()}" var="row"><tr><c:forEach items="${row}" var="cell" varStatus="at"><c:choose><c:when test="${at.first}"><th scope="row"><c:out value="${cell}"/></th></c:when><c:otherwise><td><c:out value="${cell}"/></td></c:otherwise></c:choose></c:forEach></tr></c:forEach>
            </tbody>
          </table>
        </div>
        <p><a href="${api}/tables/${table.name()}" download><fmt:message key="laboratory.download.csv"/></a></p>
      </article>
    </c:forEach>
    <c:if test="${not empty report.notes()}">
      <h2><fmt:message key="laboratory.notes"/></h2>
      <ul><c:forEach items="${report.notes()}" var="note"><li><t:english text="${note}"/></li></c:forEach></ul>
    </c:if>
  </c:if>
</t:page>
